// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
//   run_dxc FILE.hlsl PROFILE OUTPUT [OPTION...]
//
// Microsoft's compiler of HLSL, which comes as a library, as a program. Prints what it has to say;
// exit code 1 where it refuses the file.

#include <cstdio>
#include <cstring>
#include <dxcapi.h>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

std::wstring wide(const char* text) { return std::wstring(text, text + std::strlen(text)); }

} // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  std::ifstream input(argv[1], std::ios::binary);
  const std::string source{std::istreambuf_iterator<char>(input), {}};
  std::vector<std::wstring> words = {L"-E", L"main", L"-T", wide(argv[2])};
  for (int i = 4; i < argc; ++i)
    words.push_back(wide(argv[i]));
  std::vector<const wchar_t*> options;
  for (const std::wstring& word : words)
    options.push_back(word.c_str());

  IDxcCompiler3* compiler = nullptr;
  if (DxcCreateInstance(CLSID_DxcCompiler, __uuidof(IDxcCompiler3),
                        reinterpret_cast<void**>(&compiler)) != 0)
    return 2;
  const DxcBuffer text = {source.data(), source.size(), DXC_CP_UTF8};
  IDxcResult* result = nullptr;
  compiler->Compile(&text, options.data(), static_cast<unsigned>(options.size()), nullptr,
                    __uuidof(IDxcResult), reinterpret_cast<void**>(&result));
  IDxcBlobUtf8* messages = nullptr;
  result->GetOutput(DXC_OUT_ERRORS, __uuidof(IDxcBlobUtf8), reinterpret_cast<void**>(&messages),
                    nullptr);
  if (messages != nullptr && messages->GetStringLength() > 0)
    std::fputs(messages->GetStringPointer(), stderr);
  HRESULT status = 0;
  result->GetStatus(&status);
  if (status != 0) return 1;
  IDxcBlob* object = nullptr;
  result->GetOutput(DXC_OUT_OBJECT, __uuidof(IDxcBlob), reinterpret_cast<void**>(&object), nullptr);
  std::ofstream output(argv[3], std::ios::binary);
  output.write(static_cast<const char*>(object->GetBufferPointer()),
               static_cast<std::streamsize>(object->GetBufferSize()));
  output.close();
  return output ? 0 : 2;
}
