using System.Text.Json;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Cityscapes;

/// <summary>
/// An instance map as polygons, to be drawn in order, the largest first. Their corners are pixels of the region, because the benchmark's
/// scripts draw polygons including their edges. Every connected region has its own polygon, without holes; unlabeled pixels have polygons
/// where they may lie in such a hole.
/// </summary>
internal static class CityscapesPolygons
{
    /// <summary>The value of unlabeled pixels in the map to outline, where 0 is not possible; no instance has it.</summary>
    private const ushort UnlabeledNumber = ushort.MaxValue;

    /// <summary>The text of the file.</summary>
    public static string Text(InstanceMap instances) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.WriteNumber("imgHeight", instances.Image.Height);
            json.WriteNumber("imgWidth", instances.Image.Width);
            json.WriteStartArray("objects");
            foreach ((string label, IReadOnlyList<Vector2D> outline) in Pieces(instances).OrderByDescending(piece => Area(piece.Outline)))
            {
                Write(json, label, outline);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        });

    private static void Write(Utf8JsonWriter json, string label, IReadOnlyList<Vector2D> outline)
    {
        json.WriteStartObject();
        json.WriteString("label", label);
        json.WriteStartArray("polygon");
        for (int i = 0; i < outline.Count; i++)
        {
            Vector2D pixel = PixelAt(outline[(i + outline.Count - 1) % outline.Count], outline[i], outline[(i + 1) % outline.Count]);
            json.WriteStartArray();
            json.WriteNumberValue((int)pixel.X);
            json.WriteNumberValue((int)pixel.Y);
            json.WriteEndArray();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static IEnumerable<(string Label, IReadOnlyList<Vector2D> Outline)> Pieces(InstanceMap instances)
    {
        var numbered = new InstanceMap(instances.Image);
        for (int i = 0; i < numbered.Ids.Length; i++)
        {
            numbered.Ids[i] = instances.Ids[i] == 0 ? UnlabeledNumber : instances.Ids[i];
        }

        var whole = new Box2D(0, 0, instances.Image.Width, instances.Image.Height);
        return from number in numbered.Ids.Distinct()
            from outline in MaskOutlines.Of(numbered, number)
            where Area(outline) > 0 && (number != UnlabeledNumber || !outline.Any(corner => IsOnEdge(corner, whole)))
            select (number == UnlabeledNumber ? CityscapesLabels.Unlabeled.Name : CityscapesLabels.OfInstance(number)!.Name, outline);
    }

    private static bool IsOnEdge(Vector2D corner, Box2D image) =>
        corner.X == image.XMin || corner.X == image.XMax || corner.Y == image.YMin || corner.Y == image.YMax;

    /// <summary>
    /// The pixel at a corner of an outline. The outline runs along pixel borders with the region on its right, so the pixel's centre is
    /// half a pixel inside along both axes.
    /// </summary>
    private static Vector2D PixelAt(Vector2D before, Vector2D corner, Vector2D after) =>
        corner + ((Inward(before, corner) + Inward(corner, after)) * 0.5) + new Vector2D(-0.5, -0.5);

    private static Vector2D Inward(Vector2D from, Vector2D to)
    {
        Vector2D along = to - from;
        return new Vector2D(-along.Y, along.X) * (1 / along.Length);
    }

    /// <summary>Positive for the outline of a region, negative for that of a hole.</summary>
    private static double Area(IReadOnlyList<Vector2D> outline) =>
        outline.Select((corner, i) => corner.Cross(outline[(i + 1) % outline.Count])).Sum() / 2;
}
