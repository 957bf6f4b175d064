using System.Globalization;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Sessions.Reading;

/// <summary>The lane widths of the roads of a session.</summary>
/// <param name="Ordinary">Lane width of ordinary roads, metres.</param>
/// <param name="Narrow">Lane width of narrow roads, metres.</param>
internal sealed record LaneWidths(double Ordinary, double Narrow)
{
    /// <summary>Reads the settings of a session.</summary>
    /// <exception cref="DatasetFormatException">A width is not a number of metres above 0; the message names the field.</exception>
    public static LaneWidths Of(JsonFields settings) =>
        new(Width(settings, "laneWidth", RoadGeometry.LaneWidth), Width(settings, "narrowLaneWidth", RoadGeometry.NarrowLaneWidth));

    private static double Width(JsonFields settings, string name, double usual)
    {
        string? text = settings.OptionalText(name);
        return text is null ? usual
            : double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double metres)
            && metres > 0
            && double.IsFinite(metres)
                ? metres
            : throw new DatasetFormatException($"{SessionInfo.FileName}: settings.{name} must be metres above 0, not '{text}'.");
    }
}
