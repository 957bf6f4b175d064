using System.CommandLine;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Arguments;

/// <summary>The options of the lane indicators. Several commands share them.</summary>
internal static class LaneOptions
{
    private const double MaxMetres = 70;
    private const double MaxSeconds = 5;

    private const string LookAheadName = "--look-ahead";
    private const string LookAheadForm = "M|Ss";
    private const string LookAheadPurpose =
        "Look-ahead of the lane indicators: metres along the road, or seconds of travel, e.g. 1s; 0 is at the car";
    private const string LookAheadRange = "metres from 0 to 70, or seconds from 0 to 5, e.g. 1s";
    private const string WidthForm = "M";
    private const string WidthRange = "a number from 2 to 10";
    private const string LaneWidthName = "--lane-width";
    private const string LaneWidthPurpose = "Lane width of ordinary roads, metres";
    private const string NarrowLaneWidthName = "--narrow-lane-width";
    private const string NarrowLaneWidthPurpose = "Lane width of narrow roads, metres";

    /// <summary>The distance ahead of the car at which the indicators are measured.</summary>
    public static Option<LookAhead> LookAhead() =>
        WithDefault(
            ValueParsers.Parsed(LookAheadName, LookAheadForm, LookAheadPurpose, Parse, LookAheadRange),
            Geometry.Lanes.LookAhead.Thesis
        );

    /// <summary>As <see cref="LookAhead"/>, without a default.</summary>
    public static Option<LookAhead?> OptionalLookAhead() =>
        ValueParsers.Optional(LookAheadName, LookAheadForm, LookAheadPurpose, Parse, LookAheadRange);

    /// <summary>The table of measured paint, by which lanes have the widths that are painted.</summary>
    public static Option<FileInfo?> Paint() =>
        new("--paint")
        {
            Description = "Painted lines measured by roads paint: lanes are as painted where they are known",
            HelpName = "FILE",
        };

    /// <summary>Width of ordinary lanes.</summary>
    public static Option<double> LaneWidth() => Width(LaneWidthName, LaneWidthPurpose, RoadGeometry.LaneWidth);

    /// <summary>As <see cref="LaneWidth"/>, without a default.</summary>
    public static Option<double?> OptionalLaneWidth() => OptionalWidth(LaneWidthName, LaneWidthPurpose);

    /// <summary>Width of narrow lanes.</summary>
    public static Option<double> NarrowLaneWidth() => Width(NarrowLaneWidthName, NarrowLaneWidthPurpose, RoadGeometry.NarrowLaneWidth);

    /// <summary>As <see cref="NarrowLaneWidth"/>, without a default.</summary>
    public static Option<double?> OptionalNarrowLaneWidth() => OptionalWidth(NarrowLaneWidthName, NarrowLaneWidthPurpose);

    private static Option<double> Width(string name, string purpose, double metres) =>
        WithDefault(ValueParsers.Parsed(name, WidthForm, purpose, ParseWidth, WidthRange), metres);

    private static Option<double?> OptionalWidth(string name, string purpose) =>
        ValueParsers.Optional(name, WidthForm, purpose, ParseWidth, WidthRange);

    private static double? ParseWidth(string text) => NumberText.Read(text) is >= 2 and <= 10 and var width ? width : null;

    private static LookAhead? Parse(string text)
    {
        // At 1 m/s, the distance in metres equals the time in seconds.
        const double speed = 1;
        return
            Geometry.Lanes.LookAhead.Parse(text) is { } lookAhead
            && lookAhead.DistanceAt(speed) <= (text.EndsWith('s') ? MaxSeconds : MaxMetres)
            ? lookAhead
            : null;
    }

    private static Option<T> WithDefault<T>(Option<T> option, T value)
    {
        option.DefaultValueFactory = _ => value;
        return option;
    }
}
