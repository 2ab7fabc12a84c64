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
  const char* result; // declares the result, of a type
};

const Language& words_of(SourceLanguage language) {
  static const Language words[] = {
      {"const float ", "f", "sqrtf", "fmaxf", "fminf", "struct {} lobe;"},
      {"float ", "", "sqrt", "max", "min", "{} lobe;"},
      {"float ", "", "sqrt", "max", "min", "{} lobe;"},
      {"let ", "", "sqrt", "max", "min", "var lobe: {};"},
      {"const ", "", "Math.sqrt", "Math.max", "Math.min", "const lobe = {{}};"}};
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
  void field(const std::string& name, const std::string& expression) {
    line(fmt::format("lobe.{} = {};", name, expression));
  }
  void result(const char* type) { line(fmt::format(fmt::runtime(words_.result), type)); }
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

// Channels of the second lobe's A B C D come after those of the terms.
constexpr int k_second = LobePolynomial::k_channels;

// The sum over all terms of one channel.
std::string channel_sum(const Writer& w, const LobePolynomial& polynomial, int channel) {
  std::string sum;
  int term = 0, in_line = 0;
  for (int j = 0; j <= polynomial.degree; ++j)
    for (int i = 0; i <= polynomial.degree - j; ++i, ++term) {
      const float c = channel < k_second ? polynomial.term(term)[channel]
                                         : polynomial.second_term(term)[channel - k_second];
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

const char* type_of(const LobePolynomial& polynomial) {
  return polynomial.two_lobes() ? "OpenltcTwoLobes" : "OpenltcLobe";
}

// The fields of a lobe, their names after `prefix`, from the values a b c d after it.
void write_lobe(Writer& w, const std::string& prefix) {
  const std::string half = w.number(0.5), tiny = w.number(1e-30);
  // What was factored out of M^-1: alpha, or 1.
  w.field(prefix + "m00", fmt::format("{0}a * cos_o - width * {0}b * sin_o", prefix));
  w.field(prefix + "m02", fmt::format("{0}a * sin_o + width * {0}b * cos_o", prefix));
  w.field(prefix + "m20", fmt::format("width * ({0}c * cos_o - {0}d * sin_o)", prefix));
  w.field(prefix + "m22", fmt::format("width * ({0}c * sin_o + {0}d * cos_o)", prefix));
  w.field(prefix + "det",
          w.max(fmt::format("width * ({0}a * {0}d - width * {0}b * {0}c)", prefix), tiny));
  const std::string length2 = prefix + "length2";
  w.value(length2, fmt::format("lobe.{0}m00 * lobe.{0}m00 + lobe.{0}m20 * lobe.{0}m20", prefix));
  w.field(prefix + "share", fmt::format("{} + {} * lobe.{}m00 / {}", half, half, prefix,
                                        w.sqrt(w.max(length2, tiny))));
}

std::string body(const LobePolynomial& polynomial, SourceLanguage language) {
  Writer w(language);
  const std::string zero = w.number(0), one = w.number(1), two = w.number(2);
  const std::string half = w.number(0.5);
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
  if (polynomial.two_lobes()) {
    w.value("t", channel_sum(w, polynomial, 6));
    for (int k = 0; k < 4; ++k)
      w.value(std::string("second_") + channels[k], channel_sum(w, polynomial, k_second + k));
  }
  w.result(type_of(polynomial));
  write_lobe(w, "");
  if (polynomial.two_lobes()) {
    write_lobe(w, "second_");
    w.field("second_weight", fmt::format("{} + {} * t / {}", half, half, w.sqrt(one + " + t * t")));
  }
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
         "//   n5     its Schlick-weighted part: specular albedo = F0 n1 + (F90 - F0) n5.\n";
  if (polynomial.two_lobes())
    out +=
        "//   second_...  the same of a second lobe, but for n1 and n5, which both share: its part "
        "of\n"
        "//   them is second_weight, that of the first the rest.\n";
  return out + "\n";
}

} // namespace

std::string to_source(const LobePolynomial& polynomial, SourceLanguage language) {
  const bool two = polynomial.two_lobes();
  const std::string function =
      "openltc_" + identifier(polynomial.metadata.brdf) + (two ? "_two_lobes" : "_lobe");
  const std::string type = type_of(polynomial), code = body(polynomial, language);
  std::string out = comment(polynomial);
  std::string fields = "  float m00, m02, m20, m22, det, share, n1, n5;\n";
  if (two)
    fields += "  float second_m00, second_m02, second_m20, second_m22, second_det, second_share;\n"
              "  float second_weight;\n";
  const std::string guard = two ? "OPENLTC_TWO_LOBES" : "OPENLTC_LOBE";
  const std::string structure = fmt::format("#ifndef {0}\n#define {0}\nstruct {1} {{\n{2}}};\n"
                                            "#endif\n\n",
                                            guard, type, fields);
  switch (language) {
  case SourceLanguage::c: {
    std::string once = function + "_h";
    for (char& c : once)
      c = char(std::toupper(static_cast<unsigned char>(c)));
    out += fmt::format("#ifndef {0}\n#define {0}\n\n#include <math.h>\n\n", once) + structure;
    out += fmt::format("static inline struct {} {}(float roughness, float cos_theta) "
                       "{{\n{}}}\n\n#endif\n",
                       type, function, code);
    break;
  }
  case SourceLanguage::glsl:
  case SourceLanguage::hlsl:
    out += structure;
    out += fmt::format("{} {}(float roughness, float cos_theta) {{\n{}}}\n", type, function, code);
    break;
  case SourceLanguage::wgsl:
    out += fmt::format("struct {} {{\n  m00: f32, m02: f32, m20: f32, m22: f32,\n  det: f32, "
                       "share: f32, n1: f32, n5: f32,\n",
                       type);
    if (two)
      out += "  second_m00: f32, second_m02: f32, second_m20: f32, second_m22: f32,\n"
             "  second_det: f32, second_share: f32, second_weight: f32,\n";
    out += fmt::format("}}\n\nfn {}(roughness: f32, cos_theta: f32) -> {} {{\n{}}}\n", function,
                       type, code);
    break;
  case SourceLanguage::javascript:
    out += fmt::format("export function {}(roughness, cos_theta) {{\n{}}}\n", function, code);
    break;
  }
  return out;
}

} // namespace openltc::table
