using System.Globalization;
using System.Text;
using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Boxes;

/// <summary>Writes the boxes and fractions of a scene's cuboids, as docs/boxes-schema.md describes.</summary>
internal static class BoxSceneWriter
{
    private static readonly JsonWriterOptions Indented = new() { Indented = true, NewLine = "\n" };

    public static string Write(BoxScene scene)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream, Indented))
        {
            json.WriteStartObject();
            json.WriteStartArray("cuboids");
            Cuboid[] cuboids = [.. scene.Cuboids.Select(cuboid => cuboid.Cuboid)];
            for (int i = 0; i < scene.Cuboids.Count; i++)
            {
                WriteCuboid(json, scene, i, cuboids);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(stream.ToArray());
    }

    private static void WriteCuboid(Utf8JsonWriter json, BoxScene scene, int index, Cuboid[] cuboids)
    {
        (string? name, Cuboid cuboid) = scene.Cuboids[index];
        CuboidProjection projection = CuboidProjector.Project(scene.Camera, cuboid);
        double? occluded = SolidOcclusion.FractionOf(scene.Camera, cuboids, index, projection);

        json.WriteStartObject();
        json.WriteString("name", name);
        json.WriteString("outcome", JsonName.Of(projection.Outcome));
        WriteBox(json, "box2d", projection.Box);
        WriteBox(json, "box2dAmodal", projection.AmodalBox);
        json.WriteNumber("truncatedFraction", projection.TruncatedFraction);
        WriteFraction(json, "occludedFraction", occluded);
        json.WriteString("occlusionMethod", JsonName.Of(occluded is null ? OcclusionMethod.None : OcclusionMethod.Rays));
        json.WriteNumber("distanceMetres", (cuboid.Centre - scene.Camera.Pose.Position).Length);
        json.WritePropertyName("silhouette");
        json.WriteRawValue($"[{string.Join(", ", projection.Silhouette.Select(corner => OnOneLine([corner.X, corner.Y])))}]");
        json.WriteEndObject();
    }

    private static void WriteFraction(Utf8JsonWriter json, string name, double? fraction)
    {
        if (fraction is { } value)
        {
            json.WriteNumber(name, value);
        }
        else
        {
            json.WriteNull(name);
        }
    }

    private static void WriteBox(Utf8JsonWriter json, string name, Box2D? box)
    {
        json.WritePropertyName(name);
        if (box is { } sides)
        {
            json.WriteRawValue(OnOneLine([sides.XMin, sides.YMin, sides.XMax, sides.YMax]));
        }
        else
        {
            json.WriteNullValue();
        }
    }

    // The JSON writer would put each number on a line of its own. Adding 0 turns minus zero into zero.
    private static string OnOneLine(IEnumerable<double> numbers) =>
        $"[{string.Join(", ", numbers.Select(number => (number + 0.0).ToString("R", CultureInfo.InvariantCulture)))}]";
}
