// Copyright (c) 2026 The OpenLTC authors
// SPDX-License-Identifier: MIT
//
// Straight-line code with the coefficients as literals, which compilers turn into one multiply-add
// a term: no array to index, nothing to bind. It is the same in all languages but for how a
// constant is declared and what the built-in functions are called. The maths is that of
// shade/polynomial.glsl and shade/lobe.glsl, term by term.

#include "openltc/table/container/polynomial_source.h"

#include <fmt/format.h>

#include <cctype>

namespace openltc::table {

namespace {

struct Language {
  const char* value;  // declares a constant
  const char* suffix; // of a literal
  const char* sqrt;
  const char* max;
  const char* min;
  const char* result; // declares the result
};

const Language& words_of(SourceLanguage language) {
  static const Language words[] = {
      {"const float ", "f", "sqrtf", "fmaxf", "fminf", "struct OpenltcLobe lobe;"},
      {"float ", "", "sqrt", "max", "min", "OpenltcLobe lobe;"},
      {"float ", "", "sqrt", "max", "min", "OpenltcLobe lobe;"},
      {"let ", "", "sqrt", "max", "min", "var lobe: OpenltcLobe;"},
      {"const ", "", "Math.sqrt", "Math.max", "Math.min", "const lobe = {};"}};
  return words[int(language)];
}

// A name of the metadata as a part of an identifier.
std::string identifier(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return out.empty() ? "brdf" : out;
}

// One line of text that no comment can be ended by.
std::string comment_text(const std::string& text) {
  std::string out;
  for (const char c : text)
    out += static_cast<unsigned char>(c) < 0x20 || c == '\\' ? ' ' : c;
  return out;
}

class Writer {
public:
  explicit Writer(SourceLanguage language) : words_(words_of(language)) {}

  std::string number(double value) const {
    std::string text = fmt::format("{}", float(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + words_.suffix;
  }
  std::string sqrt(const std::string& x) const { return fmt::format("{}({})", words_.sqrt, x); }
  std::string max(const std::string& a, const std::string& b) const {
    return fmt::format("{}({}, {})", words_.max, a, b);
  }
  std::string clamped(const std::string& x, const std::string& low, const std::string& high) const {
    return fmt::format("{}({}, {})", words_.min, max(x, low), high);
  }
  void line(const std::string& text) { out_ += "  " + text + "\n"; }
  void value(const std::string& name, const std::string& expression) {
    line(fmt::format("{}{} = {};", words_.value, name, expression));
  }
  void field(const char* name, const std::string& expression) {
    line(fmt::format("lobe.{} = {};", name, expression));
  }
  void result() { line(words_.result); }
  const std::string& text() const { return out_; }

private:
  const Language& words_;
  std::string out_;
};

// Name of T_i(u) T_j(v) in the function.
std::string product_name(int i, int j) {
  const std::string u = i == 0 ? "" : fmt::format("u{}", i),
                    v = j == 0 ? "" : fmt::format("v{}", j);
  return u + v;
}

void write_products(Writer& w, int degree) {
  for (const char* x : {"u", "v"})
    for (int n = 2; n <= degree; ++n) {
      const std::string before = n == 2 ? w.number(1) : fmt::format("{}{}", x, n - 2);
      w.value(fmt::format("{}{}", x, n),
              fmt::format("{} * {}1 * {}{} - {}", w.number(2), x, x, n - 1, before));
    }
  for (int j = 1; j <= degree; ++j)
    for (int i = 1; i + j <= degree; ++i)
      w.value(product_name(i, j), fmt::format("u{} * v{}", i, j));
}

// The sum over all terms of one channel.
std::string channel_sum(const Writer& w, const LobePolynomial& polynomial, int channel) {
  std::string sum;
  int term = 0, in_line = 0;
  for (int j = 0; j <= polynomial.degree; ++j)
    for (int i = 0; i <= polynomial.degree - j; ++i, ++term) {
      const float c = polynomial.term(term)[channel];
      std::string product = product_name(i, j);
      std::string literal = w.number(double(c < 0 ? -c : c));
      if (term == 0)
        sum += (c < 0 ? "-" : "") + literal;
      else {
        sum += in_line % 4 == 0 ? "\n      " : " ";
        sum += fmt::format("{} {} * {}", c < 0 ? "-" : "+", literal, product);
        ++in_line;
      }
    }
  return sum;
}

std::string body(const LobePolynomial& polynomial, SourceLanguage language) {
  Writer w(language);
  const std::string zero = w.number(0), one = w.number(1), two = w.number(2);
  const std::string half = w.number(0.5), tiny = w.number(1e-30);
  w.value("alpha", w.clamped("roughness * roughness", w.number(1e-4), one));
  const bool narrow = polynomial.width == brdf::LobeWidth::alpha;
  w.value("width", narrow ? "alpha" : one);
  w.value("cos_o", w.clamped("cos_theta", zero, one));
  w.value("sin_o", w.sqrt(one + " - cos_o * cos_o"));
  w.value("u1", two + " * " + w.sqrt("alpha") + " - " + one);
  w.value("v1", two + " * " + w.sqrt(one + " - cos_o") + " - " + one);
  write_products(w, polynomial.degree);
  const char* channels[] = {"a", "b", "c", "d", "n1", "s"};
  for (int k = 0; k < 6; ++k)
    w.value(channels[k], channel_sum(w, polynomial, k));
  w.result();
  // What was factored out of M^-1: alpha, or 1.
  w.field("m00", "a * cos_o - width * b * sin_o");
  w.field("m02", "a * sin_o + width * b * cos_o");
  w.field("m20", "width * (c * cos_o - d * sin_o)");
  w.field("m22", "width * (c * sin_o + d * cos_o)");
  w.field("det", w.max("width * (a * d - width * b * c)", tiny));
  w.value("length2", "lobe.m00 * lobe.m00 + lobe.m20 * lobe.m20");
  w.field("share",
          fmt::format("{} + {} * lobe.m00 / {}", half, half, w.sqrt(w.max("length2", tiny))));
  w.field("n1", narrow ? w.clamped("n1", zero, one) : w.max("n1", zero));
  w.value("root", w.clamped("s", zero, one));
  w.field("n5", "lobe.n1 * (root * root * root * root * root)");
  w.line("return lobe;");
  return w.text();
}

std::string comment(const LobePolynomial& polynomial) {
  const TableMetadata& m = polynomial.metadata;
  std::string out = "// Copyright (c) 2026 The OpenLTC authors\n"
                    "// SPDX-License-Identifier: MIT\n//\n"
                    "// Lobes of linearly transformed cosines, without a table.\n//\n";
  out += fmt::format("// BRDF: {}, {}\n", comment_text(m.brdf), comment_text(m.variant));
  out += fmt::format("// Made by: {} (OpenLTC {})\n", comment_text(m.command),
                     comment_text(m.tool_version));
  out += fmt::format("// Mean total variation {}, largest {}\n//\n", m.mean_tv, m.max_tv);
  out += fmt::format("// Chebyshev polynomials of total degree {} in u1 = 2 roughness - 1 and\n"
                     "// v1 = 2 sqrt(1 - cos_theta) - 1.\n//\n",
                     polynomial.degree);
  out += "//   roughness  perceptual, 0 to 1; alpha = roughness^2\n"
         "//   cos_theta  between the normal and the view direction, 0 to 1\n"
         "// gives, in the frame x in the plane of view and normal on the viewer's side, z the "
         "normal,\n"
         "//   M^-1 = [ m00 0 m02 ; 0 1 0 ; m20 0 m22 ], acting on column vectors, and its "
         "determinant;\n"
         "//   share  of the lobe above the horizon; divide the integral of the clipped lobe by "
         "it;\n"
         "//   n1     directional albedo for F = 1;\n"
         "//   n5     its Schlick-weighted part: specular albedo = F0 n1 + (F90 - F0) n5.\n\n";
  return out;
}

} // namespace

std::string to_source(const LobePolynomial& polynomial, SourceLanguage language) {
  const std::string function = "openltc_" + identifier(polynomial.metadata.brdf) + "_lobe";
  const std::string code = body(polynomial, language);
  std::string out = comment(polynomial);
  const std::string fields = "  float m00, m02, m20, m22, det, share, n1, n5;\n";
  switch (language) {
  case SourceLanguage::c: {
    std::string guard = function + "_h";
    for (char& c : guard)
      c = char(std::toupper(static_cast<unsigned char>(c)));
    out += fmt::format("#ifndef {}\n#define {}\n\n#include <math.h>\n\n", guard, guard);
    out += "#ifndef OPENLTC_LOBE\n#define OPENLTC_LOBE\nstruct OpenltcLobe {\n" + fields +
           "};\n#endif\n\n";
    out += fmt::format("static inline struct OpenltcLobe {}(float roughness, float cos_theta) "
                       "{{\n{}}}\n\n#endif\n",
                       function, code);
    break;
  }
  case SourceLanguage::glsl:
  case SourceLanguage::hlsl:
    out += "#ifndef OPENLTC_LOBE\n#define OPENLTC_LOBE\nstruct OpenltcLobe {\n" + fields +
           "};\n#endif\n\n";
    out +=
        fmt::format("OpenltcLobe {}(float roughness, float cos_theta) {{\n{}}}\n", function, code);
    break;
  case SourceLanguage::wgsl:
    out += "struct OpenltcLobe {\n  m00: f32, m02: f32, m20: f32, m22: f32,\n  det: f32, share: "
           "f32, n1: f32, n5: f32,\n}\n\n";
    out += fmt::format("fn {}(roughness: f32, cos_theta: f32) -> OpenltcLobe {{\n{}}}\n", function,
                       code);
    break;
  case SourceLanguage::javascript:
    out += fmt::format("export function {}(roughness, cos_theta) {{\n{}}}\n", function, code);
    break;
  }
  return out;
}

} // namespace openltc::table
