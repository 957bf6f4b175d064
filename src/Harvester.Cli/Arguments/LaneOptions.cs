using System.CommandLine;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Arguments;

/// <summary>The options that say how lanes are measured, the same wherever a command has them.</summary>
internal static class LaneOptions
{
    private const double MaxMetres = 70;
    private const double MaxSeconds = 5;

    private const string LookAheadName = "--look-ahead";
    private const string LookAheadForm = "M|Ss";
    private const string LookAheadPurpose = "Look-ahead of the lane indicators: metres along the road, or seconds of travel, e.g. 1s; 0 is at the car";
    private const string LookAheadRange = "metres from 0 to 70, or seconds from 0 to 5, e.g. 1s";
    private const string WidthForm = "M";
    private const string WidthRange = "a number from 2 to 10";
    private const string LaneWidthName = "--lane-width";
    private const string LaneWidthPurpose = "Lane width of ordinary roads, metres";
    private const string NarrowLaneWidthName = "--narrow-lane-width";
    private const string NarrowLaneWidthPurpose = "Lane width of narrow roads, metres";

    /// <summary>Where the indicators are measured.</summary>
    public static Option<LookAhead> LookAhead() =>
        WithDefault(ValueParsers.Parsed(LookAheadName, LookAheadForm, LookAheadPurpose, Parse, LookAheadRange),
            Geometry.Lanes.LookAhead.Thesis);

    /// <summary>The same where it may be left out.</summary>
    public static Option<LookAhead?> OtherLookAhead() =>
        ValueParsers.Optional(LookAheadName, LookAheadForm, LookAheadPurpose, Parse, LookAheadRange);

    /// <summary>Width of ordinary lanes.</summary>
    public static Option<double> LaneWidth() => Width(LaneWidthName, LaneWidthPurpose, RoadGeometry.LaneWidth);

    /// <summary>The same where it may be left out.</summary>
    public static Option<double?> OtherLaneWidth() => OtherWidth(LaneWidthName, LaneWidthPurpose);

    /// <summary>Width of narrow lanes.</summary>
    public static Option<double> NarrowLaneWidth() => Width(NarrowLaneWidthName, NarrowLaneWidthPurpose, RoadGeometry.NarrowLaneWidth);

    /// <summary>The same where it may be left out.</summary>
    public static Option<double?> OtherNarrowLaneWidth() => OtherWidth(NarrowLaneWidthName, NarrowLaneWidthPurpose);

    private static Option<double> Width(string name, string purpose, double metres) =>
        WithDefault(ValueParsers.Parsed(name, WidthForm, purpose, ParseWidth, WidthRange), metres);

    private static Option<double?> OtherWidth(string name, string purpose) =>
        ValueParsers.Optional(name, WidthForm, purpose, ParseWidth, WidthRange);

    private static double? ParseWidth(string text) => ValueParsers.Number(text) is >= 2 and <= 10 and var width ? width : null;

    private static LookAhead? Parse(string text)
    {
        // At one metre a second a time is as many metres as seconds.
        const double speed = 1;
        return Geometry.Lanes.LookAhead.Parse(text) is { } asked
            && asked.DistanceAt(speed) <= (text.EndsWith('s') ? MaxSeconds : MaxMetres) ? asked : null;
    }

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
