// Which dialect an SDL file is written in.
#include "sdl/detect.hpp"

#include <algorithm>
#include <vector>

#include "sdl/lexer.hpp"
#include "text/suggest.hpp"
#include "text/words.hpp"

namespace glint {

namespace {

/// The first line that speaks for just these dialects.
struct Evidence {
    DialectSet dialects;
    Place place;
    std::string what; ///< "'object' with 9 numbers"
};

std::string on_line(const Evidence &evidence) {
    return words(evidence.what, " on line ", evidence.place.line);
}

/// "'object' with 9 numbers", or "'max_depth'" where the keyword says it all.
std::string described(const Line &line, std::span<const DirectiveForm> forms) {
    std::string text = in_quotes(forms.front().keyword());
    if (forms.size() == 1) return text;
    const bool has_path = std::any_of(forms.begin(), forms.end(),
                                      [&](const DirectiveForm &form) { return form.is_path(0) && form.fits(line); });
    return words(text, " with ", counted(line.argument_count - (has_path ? 1 : 0), "number"));
}

class Detector {
public:
    explicit Detector(Problems &problems) : problems_(problems) {}

    void look_at(const Line &line) {
        const std::span<const DirectiveForm> forms = forms_of(line.tokens[0].text);
        if (forms.empty()) return;
        if (forms.front().keyword() == "dialect") {
            if (line.argument_count > 0 && !directive_) {
                directive_ = {line.place(line.tokens[1]), std::string(line.tokens[1].text)};
            }
            return;
        }
        DialectSet dialects;
        bool fits_any = false;
        for (const DirectiveForm &form : forms) {
            // A keyword that stands in the table once is evidence however badly its line goes on.
            if (!form.fits(line) && forms.size() > 1) continue;
            if (form.evidence.empty()) return;
            fits_any = true;
            dialects = dialects | form.evidence;
        }
        if (!fits_any) return;
        note(line, forms, dialects);
        const auto same = [&](const Evidence &known) { return known.dialects == dialects; };
        if (std::any_of(evidence_.begin(), evidence_.end(), same)) return;
        evidence_.push_back({dialects, line.place(line.tokens[0]), described(line, forms)});
    }

    std::optional<DetectedDialect> decide(std::string_view wanted) {
        if (!wanted.empty()) return by_name(wanted, {}, "the caller asked for it");
        if (directive_)
            return by_name(directive_->name, directive_->place, words("'dialect' on line ", directive_->place.line));

        DialectSet candidates = DialectSet::all();
        for (const Evidence &evidence : evidence_) candidates = candidates & evidence.dialects;
        if (candidates.empty()) return tell_mixture(), std::nullopt;
        if (evidence_.empty()) return DetectedDialect{Dialect::mobile2013, "no line shows another dialect"};
        // Of raycife's own form of a light no line is found: then it reads as path2005 does, and that is the plainer.
        if (candidates.has(Dialect::path2005)) candidates = candidates.without(Dialect::raycife);
        const std::optional<Dialect> dialect = candidates.only();
        if (!dialect) return tell_ambiguity(candidates), std::nullopt;
        return DetectedDialect{*dialect, deciding_lines(*dialect)};
    }

    /// What there was to go by, for who wants to know more than the reason.
    [[nodiscard]] std::vector<DialectEvidence> findings() const {
        std::vector<DialectEvidence> all;
        for (const Finding &finding : findings_) all.push_back(finding.evidence);
        return all;
    }

    /// The name behind the file's own `dialect` directive, if there is one.
    [[nodiscard]] std::optional<std::string_view> directive_name() const {
        return directive_ ? std::optional<std::string_view>(directive_->name) : std::nullopt;
    }
    [[nodiscard]] Place directive_place() const { return directive_->place; }

private:
    struct Directive {
        Place place;
        std::string name;
    };

    /// A kind of line: the same keyword and dialects, and where the keyword has several forms, as many arguments.
    struct Finding {
        const DirectiveForm *keyword;
        uint64_t argument_count;
        DialectSet dialects;
        DialectEvidence evidence;
    };

    void note(const Line &line, std::span<const DirectiveForm> forms, DialectSet dialects) {
        const uint64_t count = forms.size() > 1 ? line.argument_count : 0;
        for (const Finding &known : findings_) {
            const bool same = known.keyword == forms.data() && known.argument_count == count;
            if (same && known.dialects == dialects) return;
        }
        Finding finding{forms.data(), count, dialects, {line.number, described(line, forms), {}}};
        for (size_t i = 0; i < dialect_count; ++i) {
            const auto dialect = static_cast<Dialect>(i);
            if (dialects.has(dialect)) finding.evidence.dialects.emplace_back(dialect_name(dialect));
        }
        findings_.push_back(std::move(finding));
    }

    std::optional<DetectedDialect> by_name(std::string_view name, const Place &place, std::string reason) {
        if (const auto dialect = dialect_named(name)) return DetectedDialect{*dialect, std::move(reason)};
        std::vector<std::string_view> known;
        std::string listed;
        for (size_t i = 0; i < dialect_count; ++i) {
            known.push_back(dialect_name(static_cast<Dialect>(i)));
            listed += words(i > 0 ? ", " : "", known.back());
        }
        const auto nearest = nearest_word(name, known);
        problems_.error(place, words("there is no dialect ", in_quotes(name)),
                        nearest ? words("did you mean '", *nearest, "'?") : words("the dialects are ", listed));
        return std::nullopt;
    }

    /// The line that leaves this dialect alone, where there is one; else those that do so together.
    [[nodiscard]] std::string deciding_lines(Dialect dialect) const {
        const auto leave = [&](DialectSet dialects) {
            if (dialect == Dialect::path2005) dialects = dialects.without(Dialect::raycife);
            return dialects == DialectSet(dialect);
        };
        for (const Evidence &evidence : evidence_) {
            if (leave(evidence.dialects)) return on_line(evidence);
        }
        std::string lines;
        DialectSet left = DialectSet::all();
        for (const Evidence &evidence : evidence_) {
            if ((left & evidence.dialects) == left) continue;
            left = left & evidence.dialects;
            lines += words(lines.empty() ? "" : " and ", on_line(evidence));
            if (leave(left)) break;
        }
        return lines;
    }

    void tell_mixture() {
        // Name two lines that contradict each other, if two alone do; else the first and the last of all that do.
        const Evidence *first = &evidence_.front(), *second = &evidence_.back();
        for (size_t i = 0; i < evidence_.size(); ++i) {
            for (size_t j = 0; j < i; ++j) {
                if ((evidence_[i].dialects & evidence_[j].dialects).empty()) {
                    first = &evidence_[j];
                    second = &evidence_[i];
                    i = evidence_.size() - 1;
                    break;
                }
            }
        }
        problems_.error(second->place,
                        words("the file mixes dialects: ", on_line(*first), " is ", first->dialects.names(), ", ",
                              on_line(*second), " is ", second->dialects.names()),
                        words("if it is one of them, a first line such as 'dialect ", any_of(first->dialects),
                              "' or 'dialect ", any_of(second->dialects), "' settles it"));
    }

    void tell_ambiguity(DialectSet candidates) {
        const Evidence &evidence = evidence_.back();
        std::string readings, lines, last;
        bool differ = true;
        for (size_t i = 0; i < dialect_count; ++i) {
            const auto dialect = static_cast<Dialect>(i);
            if (!candidates.has(dialect)) continue;
            const std::string reading = reading_in(dialect, evidence);
            differ = differ && reading != last;
            last = reading;
            readings += words(readings.empty() ? "" : " or as ", dialect_name(dialect), reading);
            lines += words(lines.empty() ? "" : " or ", "'dialect ", dialect_name(dialect), "'");
        }
        // Where the words are the same, the meaning of the file is not: of the line's coefficients, or of other lines.
        if (!differ) readings = candidates.names();
        problems_.error(
            evidence.place, words(evidence.what, " can be read as ", readings),
            words("a line ", lines, " settles it", differ ? "" : "; scenes/sdl/README.md says how they differ"));
    }

    /// " (r g b ka ...)": how the dialect names the arguments of the line that is the evidence.
    static std::string reading_in(Dialect dialect, const Evidence &evidence) {
        Lexer lexer(evidence.place.source_line);
        Line line;
        if (!lexer.next(line)) return {};
        for (const DirectiveForm &form : forms_of(line.tokens[0].text)) {
            if (form.dialects.has(dialect) && form.fits(line)) {
                return words(" (", form.usage.substr(form.keyword().size() + 1), ")");
            }
        }
        return {};
    }

    static std::string_view any_of(DialectSet dialects) {
        for (size_t i = 0; i < dialect_count; ++i) {
            if (dialects.has(static_cast<Dialect>(i))) return dialect_name(static_cast<Dialect>(i));
        }
        return {};
    }

    Problems &problems_;
    std::optional<Directive> directive_;
    std::vector<Evidence> evidence_; ///< one entry for each distinct set of dialects
    std::vector<Finding> findings_;  ///< one entry for each distinct kind of line
};

} // namespace

std::optional<DetectedDialect> detect_dialect(std::string_view text, std::string_view wanted, Problems &problems) {
    Detector detector(problems);
    Lexer lexer(text);
    Line line;
    while (lexer.next(line)) detector.look_at(line);
    std::optional<DetectedDialect> detected = detector.decide(wanted);
    if (detected) detected->evidence = detector.findings();
    if (detected && !wanted.empty() && detector.directive_name().value_or(wanted) != wanted) {
        problems.warn(detector.directive_place(), words("the file says dialect ", in_quotes(*detector.directive_name()),
                                                        " and is read as ", wanted, ", as the caller asked"));
    }
    return detected;
}

} // namespace glint
