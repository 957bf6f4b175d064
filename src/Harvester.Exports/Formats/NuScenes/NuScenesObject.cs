using System.Text.Json;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>An object as one view shows it.</summary>
/// <param name="Id">Id in the session.</param>
/// <param name="Category">Category of nuScenes.</param>
/// <param name="Box">Its fields translation, size and rotation, as JSON.</param>
/// <param name="Speed">Speed, m/s.</param>
/// <param name="HasRider">Whether somebody sits on it; null if unknown.</param>
/// <param name="Area">Area of its box in the image, square pixels.</param>
/// <param name="VisibleArea">The part of the area that nothing hides.</param>
internal sealed record NuScenesObject(int Id, string Category, string Box, double Speed, bool? HasRider, double Area, double VisibleArea)
{
    /// <summary>Number of LiDAR points inside its box.</summary>
    public int Points { get; init; }

    /// <summary>Number of LiDAR points whose rays met it.</summary>
    public int Hits { get; init; }

    private const int MetreDecimals = 4;
    private const int QuaternionDecimals = 9;
    private const int PixelDecimals = 3;

    /// <summary>The object of a label; null if nuScenes does not annotate it.</summary>
    public static NuScenesObject? Of(ObjectLabel label) =>
        NuScenesClasses.CategoryOf(label) is { } category
            ? new NuScenesObject(
                label.Id,
                category,
                BoxOf(label.Box3D),
                label.Velocity.Length,
                label.HasRider,
                label.Box2D.Area,
                label.Box2D.Area * (1 - (label.OccludedFraction ?? 0))
            )
            : null;

    /// <summary>Writes the object as a list.</summary>
    public void Write(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        json.WriteNumber("id", Id);
        json.WriteString("category", Category);
        json.WritePropertyName("box");
        json.WriteRawValue(Box);
        json.Number("speed", Speed, MetreDecimals);
        if (HasRider is { } ridden)
        {
            json.WriteBoolean("rider", ridden);
        }

        json.Number("area", Area, PixelDecimals);
        json.Number("visible", VisibleArea, PixelDecimals);
        json.WriteNumber("points", Points);
        json.WriteNumber("hits", Hits);
        json.WriteEndObject();
    }

    /// <summary>Reads what <see cref="Write"/> wrote.</summary>
    public static NuScenesObject Read(JsonFields item) =>
        new(
            item.Integer("id"),
            item.Text("category"),
            item.RawText("box"),
            item.Number("speed"),
            item.Has("rider") ? item.Boolean("rider") : null,
            item.Number("area"),
            item.Number("visible")
        )
        {
            Points = item.Integer("points"),
            Hits = item.Integer("hits"),
        };

    private static string BoxOf(Cuboid cuboid) =>
        JsonLine.Of(json =>
        {
            Rotation rotation = Rotation.OfBody(cuboid.Axes);
            json.WriteStartObject();
            json.Numbers("translation", [cuboid.Centre.X, cuboid.Centre.Y, cuboid.Centre.Z], MetreDecimals);
            json.Numbers("size", [2 * cuboid.HalfExtents.X, 2 * cuboid.HalfExtents.Y, 2 * cuboid.HalfExtents.Z], MetreDecimals);
            json.Numbers("rotation", [rotation.W, rotation.X, rotation.Y, rotation.Z], QuaternionDecimals);
            json.WriteEndObject();
        });
}
