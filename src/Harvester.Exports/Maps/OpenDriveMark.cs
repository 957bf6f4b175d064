using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>The line at a lane's outer edge in OpenDRIVE's terms; a lane whose line is unknown has none.</summary>
internal static class OpenDriveMark
{
    public static void Write(OpenDriveXml xml, MapMarking? marking)
    {
        if (marking is not { Paint: { } paint })
        {
            return;
        }

        xml.Element(
            "roadMark",
            ("sOffset", "0"),
            ("type", TypeOf(paint.Style)),
            ("weight", "standard"),
            ("color", paint.Colour == MarkingColour.Yellow ? "yellow" : "white"),
            ("width", OpenDriveXml.Text(paint.WidthMetres)),
            ("laneChange", paint.Style == MarkingStyle.Dashed ? "both" : "none")
        );
    }

    private static string TypeOf(MarkingStyle style) =>
        style switch
        {
            MarkingStyle.Solid => "solid",
            MarkingStyle.Dashed => "broken",
            MarkingStyle.DoubleSolid => "solid solid",
            _ => throw new ArgumentOutOfRangeException(nameof(style), style, "No such style."),
        };
}
