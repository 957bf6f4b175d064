using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>A problem that shows in single lines of a log.</summary>
/// <param name="pattern">A regular expression that such a line matches; its groups may be used in the cause as $1.</param>
/// <param name="cause">What is the matter.</param>
/// <param name="advice">What to do.</param>
internal sealed class LineRule(string pattern, string cause, string advice)
{
    private readonly Regex _pattern = new(pattern, RegexOptions.IgnoreCase | RegexOptions.CultureInvariant);

    /// <summary>
    /// One finding for each rule that lines match; a line counts for the first rule alone, so that specific rules stand before general
    /// ones.
    /// </summary>
    public static IEnumerable<Finding> Apply(IReadOnlyList<LineRule> rules, IEnumerable<LogLine> lines) =>
        from line in lines
        let rule = rules.FirstOrDefault(rule => rule._pattern.IsMatch(line.Text))
        where rule is not null
        group rule.FindingOf(line) by rule into found
        select found.Last() with { Count = found.Count() };

    private Finding FindingOf(LogLine line) => new(_pattern.Match(line.Text).Result(cause), advice, line);
}
