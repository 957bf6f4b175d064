using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Tests.Models;
using Harvester.Simulation.Tests.Rendering;

namespace Harvester.Simulation.Tests.Faces;

/// <summary>Boxes of signs' faces by the table against the faces that the renderer draws.</summary>
public sealed class FaceBoxTests
{
    /// <summary>The required accuracy of each side of a face's box.</summary>
    private const double PixelTolerance = 1;

    /// <summary>The oracle draws this many times finer, as it knows a face only by the pixels whose centres it covers.</summary>
    private const int Finer = 4;

    /// <summary>The focal length of a window of 600 pixels and 50 degrees: 300 / tan 25°.</summary>
    private const double FocalPixels = 643.35;

    /// <summary>The side of the piece of such a window that is drawn; a sign of 1.08 m at 5 m takes 139.</summary>
    private const int Side = 200;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Box_of_a_face_is_within_a_pixel_of_its_rendering()
    {
        var random = new Random(7);
        foreach (Model model in ModelCatalogueTests.Catalogue.Signs)
        {
            ModelFace face = Assert.Single(ModelFaces.Table.Of(model.Name));
            Mesh drawn = FaceParts.FaceOf(model);
            for (int i = 0; i < 12; i++)
            {
                double distance = 5 * Math.Pow(12, random.NextDouble());
                double turn = (random.NextDouble() * 120) - 60;
                double eyeHeight = 1 + random.NextDouble();
                RenderCamera camera = CameraAt(eyeHeight, distance);
                var pose = new Pose(new Vector3D(0, distance, 0), Axes.FromHeading(turn));
                Box2D? rendered = Silhouette.BoxOf(
                    TestScene.Render(camera with { Width = Side * Finer, Height = Side * Finer }, new MeshInstance(drawn, pose, 1)),
                    1
                );
                Box2D box = CuboidProjector
                    .Project(CuboidBoxTests.Analytic(camera), face.CuboidAt(pose), FaceOutline.EdgesOf(face, pose))
                    .Box!.Value;

                double error = MaxDifference(box, rendered!.Value);
                Assert.True(
                    error <= PixelTolerance,
                    FormattableString.Invariant($"{model.Name} at {distance:0.0} m turned {turn:0} degrees: {error:0.00} px")
                );
            }
        }
    }

    /// <summary>Looks at the sign's middle, 2.3 m up.</summary>
    private static RenderCamera CameraAt(double height, double distance)
    {
        double pitch = Math.Atan2(2.3 - height, distance) * 180 / Math.PI;
        double fov = 2 * Math.Atan(Side / 2.0 / FocalPixels) * 180 / Math.PI;
        return new RenderCamera(
            new Pose(new Vector3D(0, 0, height), Axes.FromEuler(new EulerAngles(pitch, 0, 0))),
            fov,
            1,
            0.15,
            Side,
            Side
        );
    }

    private static double MaxDifference(Box2D box, Box2D fine) =>
        new[]
        {
            box.XMin - (fine.XMin / Finer),
            box.YMin - (fine.YMin / Finer),
            box.XMax - (fine.XMax / Finer),
            box.YMax - (fine.YMax / Finer),
        }.Max(Math.Abs);
}
