using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Reports.Sessions;

/// <summary>An object of a frame in the data of a report, as the page's scripts read it. Numbers are rounded to what is visible.</summary>
internal static class ReportObject
{
    private const int Decimals = 2;
    private const int PixelDecimals = 1;

    /// <summary>Those of the labels, because the page's filters compare heights and areas.</summary>
    private const int BoxDecimals = 3;

    private const int DegreeDecimals = 0;

    /// <summary>Writes what may change from frame to frame.</summary>
    /// <param name="json">Receives the object.</param>
    /// <param name="item">The label.</param>
    /// <param name="camera">The camera of the frame.</param>
    /// <param name="isPost">Whether its faces or heads are objects of their own.</param>
    public static void Write(Utf8JsonWriter json, ObjectLabel item, Camera camera, bool isPost)
    {
        json.WriteStartObject();
        json.WriteNumber("id", item.Id);
        if (isPost)
        {
            json.WriteBoolean("post", true);
        }

        WriteBox(json, "box", item.Box2D, BoxDecimals);
        if (item.Box2DAmodal != item.Box2D)
        {
            WriteBox(json, "amodal", item.Box2DAmodal, PixelDecimals);
        }

        if (item.Box2DVisible is { } visible)
        {
            WriteBox(json, "visible", visible, PixelDecimals);
        }

        WriteCuboid(json, item.Box3D, camera);
        json.Numbers("at", [item.Box3D.Centre.X, item.Box3D.Centre.Y], Decimals);
        json.Number("heading", Angles.HeadingDegrees(item.Box3D.Axes.Forward), DegreeDecimals);
        json.Number("truncated", item.TruncatedFraction, Decimals);
        json.Number("occluded", item.OccludedFraction, Decimals);
        json.WriteString("method", JsonName.Of(item.OcclusionMethod));
        json.Number("distance", item.DistanceMetres, Decimals);
        json.Number("speed", item.Velocity.Length, Decimals);
        if (item.Face?.Light is { } light)
        {
            json.WriteString("light", JsonName.Of(light.State));
        }

        if (item.Lights is { } lamps)
        {
            WriteLamps(json, lamps);
        }

        if (item.Joints is { } joints)
        {
            WriteJoints(json, joints);
        }

        json.WriteEndObject();
    }

    private static void WriteLamps(Utf8JsonWriter json, VehicleLights lamps)
    {
        json.WriteStartArray("lamps");
        foreach (
            (string name, bool isLit) in new[]
            {
                ("brake", lamps.Brake),
                ("left", lamps.Left),
                ("right", lamps.Right),
                ("head", lamps.Head),
            }
        )
        {
            if (isLit)
            {
                json.WriteStringValue(name);
            }
        }

        json.WriteEndArray();
    }

    /// <summary>A pixel and whether it is visible, 1 or 0, for each joint; null for one without a pixel.</summary>
    private static void WriteJoints(Utf8JsonWriter json, JointsLabel joints)
    {
        json.WriteStartArray("joints");
        foreach (JointLabel joint in joints.Joints)
        {
            if (joint.Pixel is { } pixel)
            {
                json.Values([pixel.X, pixel.Y, joint.Visibility == JointVisibility.Visible ? 1 : 0], PixelDecimals);
            }
            else
            {
                json.WriteNullValue();
            }
        }

        json.WriteEndArray();
    }

    /// <summary>The pixels of the corners, or of what the near plane leaves of the edges.</summary>
    private static void WriteCuboid(Utf8JsonWriter json, Cuboid cuboid, Camera camera)
    {
        Projection[] corners = [.. Enumerable.Range(0, Cuboid.CornerCount).Select(number => camera.Project(cuboid.Corner(number)))];
        if (corners.All(corner => corner.Outcome != ProjectionOutcome.BehindNearPlane))
        {
            json.Numbers("corners", [.. corners.SelectMany(corner => new[] { corner.U, corner.V })], PixelDecimals);
            return;
        }

        json.WriteStartArray("edges");
        foreach ((Vector2D start, Vector2D end) in CuboidEdges.Of(camera, cuboid))
        {
            json.Values([start.X, start.Y, end.X, end.Y], PixelDecimals);
        }

        json.WriteEndArray();
    }

    private static void WriteBox(Utf8JsonWriter json, string name, Box2D box, int decimals) =>
        json.Numbers(name, [box.XMin, box.YMin, box.XMax, box.YMax], decimals);
}
