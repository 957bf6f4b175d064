using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Compares the versions of game and scripting API at the beginning of a run.</summary>
internal static class VersionCheck
{
    private static readonly Regex Versions = new(
        @"API (?<api>\d+(\.\d+){1,3}), GTA V (?<edition>Legacy|Enhanced) (?<build>\d+(\.\d+){1,3})",
        RegexOptions.CultureInvariant
    );

    /// <summary>The first Legacy build whose memory release 3.6.0 cannot read, and the first version of the API that can.</summary>
    private static readonly (Version Build, Version Api) Newer = (new Version(1, 0, 3258), new Version(3, 6, 0, 89));

    /// <summary>The Enhanced fork numbers its API from 3.9.</summary>
    private static readonly Version FirstOfEnhanced = new(3, 9);

    public static IEnumerable<Finding> Of(IReadOnlyList<LogLine> lines)
    {
        if (lines.FirstOrDefault(line => Versions.IsMatch(line.Text)) is not { } line)
        {
            return [];
        }

        Match match = Versions.Match(line.Text);
        var api = new Version(match.Groups["api"].Value);
        var build = new Version(match.Groups["build"].Value);
        bool isEnhanced = match.Groups["edition"].Value == "Enhanced";
        return isEnhanced && api < FirstOfEnhanced
                ? [new Finding("ScriptHookVDotNet does not support Enhanced.", "Install its fork ScriptHookVDotNetEnhanced.", line)]
            : !isEnhanced && build >= Newer.Build && api < Newer.Api
                ?
                [
                    new Finding(
                        "This build of the game is newer than ScriptHookVDotNet knows.",
                        "Install the latest nightly of ScriptHookVDotNet.",
                        line
                    ),
                ]
            : [];
    }
}
