using System.Globalization;
using Harvester.Datasets.Derivation;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;

namespace Harvester.Runs.Relabelling;

/// <summary>The key of a relabelling: the recorded session and every option that changes what is written.</summary>
public static class RelabelKey
{
    /// <summary>The key of a relabelling: equal for runs that give the same bytes.</summary>
    public static string Of(SessionReader session, RelabelOptions changes) => WorkKey.Of([session], Texts(changes));

    private static IEnumerable<string> Texts(RelabelOptions changes) =>
        [
            "relabel",
            string.Join(',', changes.Classes ?? []),
            Text(changes.RangeMetres),
            Text(changes.MinBoxAreaPixels),
            Text(changes.MinBoxSidePixels),
            Text(changes.MaxOccludedFraction),
            changes.Lens is { } lens ? Text(lens) : "",
            changes.Faces is { } faces ? FaceTableWriter.Text(faces) : "",
            changes.FacesName ?? "",
            changes.Roads is { } roads ? Text(roads) : "",
            changes.RoadsName ?? "",
            changes.LookAhead?.ToString() ?? "",
            Text(changes.LaneWidthMetres),
            Text(changes.NarrowLaneWidthMetres),
            changes.Paint is { } paint ? Text(paint) : "",
            changes.PaintName ?? "",
            changes.Shard.ToString(),
        ];

    private static string Text(double? number) => number?.ToString("R", CultureInfo.InvariantCulture) ?? "";

    private static string Text(Lens lens) =>
        string.Join(',', ((double?[])[lens.FocalScale, lens.CentreOffsetX, lens.CentreOffsetY, lens.K1, lens.K2]).Select(Text));

    private static string Text(PaintTable paint)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        PaintCsvWriter.Write(paint, text);
        return text.ToString();
    }

    private static string Text(RoadNetwork roads)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        RoadCsvWriter.Write(roads, text);
        return text.ToString();
    }
}
