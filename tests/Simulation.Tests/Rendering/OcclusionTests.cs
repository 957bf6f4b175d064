using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Tests.Models;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Occlusion by rays, compared with the fraction of an object's pixels that vanish when the others are drawn too.</summary>
public sealed class OcclusionTests
{
    /// <summary>The required accuracy, on average.</summary>
    private const double MaxMeanError = 0.1;

    /// <summary>With fewer pixels, the rendered fraction itself is too coarse.</summary>
    private const int MinPixels = 200;

    private static readonly RenderCamera Eye = TestScene.Camera with { Width = 640, Height = 480, VerticalFovDegrees = 50 };

    [Fact]
    [Trait("Category", "Heavy")]
    public void Estimate_is_near_the_rendered_occlusion_on_average()
    {
        var errors = new List<double>();
        int hidden = 0;
        for (int seed = 1; seed <= 6; seed++)
        {
            MeshInstance[] cars = Cars(seed, out Model[] models);
            var scene = new RenderScene([]);
            scene.SetDynamic(cars);
            RenderTarget all = TestScene.Render(scene, Eye);
            Camera camera = CuboidBoxTests.Analytic(Eye);
            var rays = new SceneRayCaster(scene);
            for (int i = 0; i < cars.Length; i++)
            {
                int alone = Silhouette.Count(TestScene.Render(Eye, cars[i]), cars[i].Handle);
                if (alone < MinPixels)
                {
                    continue;
                }

                double rendered = 1 - ((double)Silhouette.Count(all, cars[i].Handle) / alone);
                var cuboid = Cuboid.FromModel(models[i].Min, models[i].Max, cars[i].Pose);
                OcclusionEstimate estimate = new OcclusionEstimator().Estimate(
                    camera,
                    cuboid,
                    CuboidProjector.Project(camera, cuboid),
                    cars[i].Handle,
                    RayHit.World,
                    rays
                );
                errors.Add(Math.Abs(estimate.OccludedFraction - rendered));
                hidden += rendered is > 0.1 and < 0.9 ? 1 : 0;
            }
        }

        Assert.True(errors.Count > 30 && hidden > 8, $"Only {errors.Count} cars, {hidden} of them partly hidden.");
        Assert.InRange(errors.Average(), 0, MaxMeanError);
    }

    private static MeshInstance[] Cars(int seed, out Model[] models)
    {
        var random = new Random(seed);
        IReadOnlyList<Model> vehicles = ModelCatalogueTests.Catalogue.Vehicles;
        models = Enumerable.Range(0, 10).Select(_ => vehicles[random.Next(vehicles.Count)]).ToArray();
        return models
            .Select(
                (model, i) =>
                    new MeshInstance(
                        model.Variant(i),
                        new Pose(
                            new Vector3D((random.NextDouble() * 8) - 4, 8 + (i * 4), -1.5 - model.Min.Z),
                            Axes.FromHeading(random.NextDouble() * 360)
                        ),
                        i + 1
                    )
            )
            .ToArray();
    }
}
