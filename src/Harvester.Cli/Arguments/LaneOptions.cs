using System.CommandLine;
using Harvester.Geometry.Lanes;

namespace Harvester.Cli.Arguments;

/// <summary>The options that say how lanes are measured, the same wherever a command has them.</summary>
internal static class LaneOptions
{
    private const double FarthestMetres = 70;
    private const double LongestSeconds = 5;

    /// <summary>Where the indicators are measured.</summary>
    public static Option<LookAhead> LookAhead() => ValueParsers.Parsed(
        "--look-ahead",
        "M|Ss",
        "How far ahead the lane indicators are measured: metres along the road, or seconds of way as 1s; 0 is at the car",
        Parse,
        "metres from 0 to 70, or seconds from 0 to 5 as 1s");

    /// <summary>Width of ordinary lanes.</summary>
    public static Option<double> LaneWidth() => ValueParsers.Number(
        "--lane-width", "M", "Width of the lanes of ordinary roads, metres", value => value is >= 2 and <= 10, "a number from 2 to 10");

    private static LookAhead? Parse(string text)
    {
        bool isTime = text.EndsWith('s');
        double? value = ValueParsers.Number(isTime ? text[..^1] : text);
        return value is not { } number || number < 0 || number > (isTime ? LongestSeconds : FarthestMetres) ? null
            : isTime ? Geometry.Lanes.LookAhead.OfSeconds(number)
            : Geometry.Lanes.LookAhead.OfMetres(number);
    }
}
