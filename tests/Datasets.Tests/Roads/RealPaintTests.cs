using System.Text.Json;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>
/// The paint of one frame of the real game, found from its image, depth, pose and the road network, against what was measured on the frame
/// by other means.
/// </summary>
public sealed class RealPaintTests(ITestOutputHelper output)
{
    private const string Scene = "frame-208/scene.json";

    [RealWorldFact(Scene)]
    public void Lines_of_the_real_frame_are_found_within_5_cm()
    {
        Camera camera = CameraOf(Scene);
        byte[] rgb = PictureReader.Read(RealWorldFactAttribute.PathOf("frame-208/image.jpg")!).Bytes;
        float[] depths = DepthsOf("frame-208/depth.png");
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        var roads = new PaintRoads(new RoadCurves(network));
        var evidence = new PaintEvidence();

        new PaintScanner(roads).Scan(
            new PaintImage(camera, rgb, new DepthGround(camera, depths, null), null) { Depths = depths },
            0,
            evidence
        );
        PaintTable table = PaintTableBuilder.Build(roads, evidence);

        List<(double Lateral, double Ahead, LinePaint Line)> found = [];
        foreach (LinkPaint link in table.Links)
        {
            foreach (LinePaint line in link.Lines)
            {
                RoadCurve curve = roads.Curves.Of(link.Link);
                for (double station = Math.Ceiling(line.FromStation); station <= line.ToStation; station++)
                {
                    Vector3D seen = camera.Pose.ToLocal(curve.PointBeside(curve.ParameterAt(station), line.OffsetAt(station)));
                    found.Add((seen.X, seen.Y, line));
                }
            }
        }

        (double Lateral, MarkingStyle Style, MarkingColour Colour)[] painted =
        [
            (2.83, MarkingStyle.Solid, MarkingColour.Yellow),
            (-3.28, MarkingStyle.Dashed, MarkingColour.White),
            (-9.38, MarkingStyle.Solid, MarkingColour.White),
        ];
        foreach ((double lateral, MarkingStyle style, MarkingColour colour) in painted)
        {
            List<(double Lateral, double Ahead, LinePaint Line)> own = found.FindAll(place => Math.Abs(place.Lateral - lateral) < 0.5);
            Assert.All(own, place => Assert.Equal((style, colour), (place.Line.Paint.Style, place.Line.Paint.Colour)));

            // The frame's own figures hold from 3 to 14 m ahead.
            double[] near = [.. own.Where(place => place.Ahead is >= 3 and <= 14).Select(place => place.Lateral).Order()];
            Assert.NotEmpty(near);
            output.WriteLine(FormattableString.Invariant($"{lateral:0.00} m: {near[near.Length / 2]:0.000} m, {style} {colour}"));
            Assert.InRange(near[near.Length / 2], lateral - 0.05, lateral + 0.05);
        }

        Assert.All(found, place => Assert.Contains(painted, line => Math.Abs(place.Lateral - line.Lateral) < 0.5));
    }

    private static Camera CameraOf(string scene)
    {
        using JsonDocument document = JsonDocument.Parse(File.ReadAllBytes(RealWorldFactAttribute.PathOf(scene)!));
        JsonElement root = document.RootElement;
        Vector3D angles = Vector(root.GetProperty("camera_rot"));
        var size = new ImageSize(root.GetProperty("width").GetInt32(), root.GetProperty("height").GetInt32());
        return new Camera(
            new Pose(Vector(root.GetProperty("camera_pos")), Axes.FromEuler(new EulerAngles(angles.X, angles.Y, angles.Z))),
            new CameraIntrinsics(
                root.GetProperty("camera_fov").GetDouble(),
                size,
                (double)size.Width / size.Height,
                nearClip: 0.15,
                Lens.Ideal
            )
        );
    }

    /// <summary>As the frame's own description says: raw = 65535 · (0.15 / z + 1.5e-5), and 0 is the sky.</summary>
    private static float[] DepthsOf(string file)
    {
        InstanceMap map = PngDecoder.ReadInstanceMap(RealWorldFactAttribute.PathOf(file)!);
        return Array.ConvertAll(map.Ids, raw => raw == 0 ? float.PositiveInfinity : (float)(0.15 * 65535 / (raw - 0.98)));
    }

    private static Vector3D Vector(JsonElement numbers) => new(numbers[0].GetDouble(), numbers[1].GetDouble(), numbers[2].GetDouble());
}
