using System.Diagnostics;
using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>Voxels of the simulated town compared with rays, which share nothing with how surfaces are put into voxels.</summary>
public sealed class OccupancyTests(ITestOutputHelper output)
{
    /// <summary>A hit this close to the side of a voxel, as part of it, may be judged either way: rounding.</summary>
    private const double SideTolerance = 1e-4;

    /// <summary>
    /// The part of the free voxels whose visibility must agree with rays to their middles: the picture's depth is that of the middle of a
    /// pixel, so at the border of what hides them a pixel and a ray may differ.
    /// </summary>
    private const double MinVisible = 0.97;

    private static readonly ImageSize Image = new(400, 300);

    /// <summary>A seed that was used while this was built, or others for figures.</summary>
    public static TheoryData<int> Seeds =>
        [
            .. (Environment.GetEnvironmentVariable("GTADATAHARVESTER_OCCUPANCY_SEEDS") ?? "71")
                .Split(' ')
                .Select(text => int.Parse(text, CultureInfo.InvariantCulture)),
        ];

    [Theory]
    [MemberData(nameof(Seeds))]
    [Trait("Category", "Heavy")]
    public void Voxels_agree_with_rays(int seed)
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = seed });
        HarvestOptions options = new()
        {
            Image = Image,
            MaxFrames = 1,
            Channels = new ChannelKeys(["occupancy"]),
        };
        LabelledTown.Harvest(game, game.Ports, options, (frame, _) => Judge(game, frame.Part<OccupancyPart>()!));
    }

    private void Judge(SimulatedGame game, OccupancyPart part)
    {
        VoxelGrid grid = part.Map.Grid;
        SceneSnapshot shown = game.Shown;
        var classes = shown.Entities.ToDictionary(static entity => entity.Handle, static entity => entity.Class);
        var random = new Random(1);
        var clock = new Stopwatch();
        (int crossed, int hits, int wrong, int wrongClass) = (0, 0, 0, 0);
        (int looked, int differ, int seen) = (0, 0, 0);
        var camera = new Camera(
            shown.Camera.Pose,
            new CameraIntrinsics(shown.Camera.VerticalFovDegrees, Image, shown.Camera.WindowAspect, shown.Camera.NearClip, Lens.Ideal)
        );
        Vector3D eye = camera.Pose.Position;
        for (int voxel = random.Next(7); voxel < part.Map.Kinds.Count; voxel += 1 + random.Next(13))
        {
            // A ray across the voxel through random points of two opposite sides.
            Vector3D middle = grid.PlaceOf(grid.CentreOf(voxel));
            double[] at = [Across(), Across(), Across(), Across()];
            (Vector3D from, Vector3D to) = random.Next(3) switch
            {
                0 => (new Vector3D(-0.5, at[0], at[1]), new Vector3D(0.5, at[2], at[3])),
                1 => (new Vector3D(at[0], -0.5, at[1]), new Vector3D(at[2], 0.5, at[3])),
                _ => (new Vector3D(at[0], at[1], -0.5), new Vector3D(at[2], at[3], 0.5)),
            };
            Vector3D start = PointOf(middle + from);
            Vector3D way = PointOf(middle + to) - start;
            crossed++;
            if (game.Ports.Rays.Cast(new Ray(start, way), way.Length, shown.Ego.Handle) is { } hit)
            {
                double along = hit.Distance / way.Length;
                if (along is > SideTolerance and < 1 - SideTolerance)
                {
                    hits++;
                    byte kind = part.Map.Kinds[voxel];
                    wrong += kind is VoxelMap.Free or VoxelMap.Enclosed ? 1 : 0;
                    bool isEntity = hit.Entity != RayHit.World;

                    // Classes of higher rank may share the voxel; entities outrank all surfaces of the static world.
                    wrongClass += isEntity && classes.ContainsKey(hit.Entity) && part.Map.Owners[voxel] == 0 ? 1 : 0;
                }
            }

            if (part.Map.Kinds[voxel] == VoxelMap.Free)
            {
                Vector3D target = grid.CentreOf(voxel);
                Vector3D line = target - eye;
                bool isSeen =
                    camera.Project(target).Outcome == ProjectionOutcome.InImage
                    && game.Ports.Rays.Cast(new Ray(eye, line), line.Length, shown.Ego.Handle) is null;
                looked++;
                seen += isSeen ? 1 : 0;
                differ += isSeen != part.Seen[voxel] ? 1 : 0;
            }
        }

        clock.Start();
        const int runs = 5;
        for (int run = 0; run < runs; run++)
        {
            var moved = new VoxelGrid(new Pose(grid.Frame.Position + new Vector3D(0, 0, 1e-6 * (run + 1)), grid.Frame.Axes), grid.Shape);
            byte[] ranks = [.. Enumerable.Range(0, SemanticClasses.Greatest + 1).Select(static kind => (byte)kind)];
            _ = game.Ports.Solids!.Fill(moved, ranks, static _ => SemanticClass.Car);
        }

        double fill = clock.Elapsed.TotalMilliseconds / runs;
        output.WriteLine(
            FormattableString.Invariant($"{crossed} voxels crossed, {hits} hits, {wrong} in voxels without surface, {wrongClass} without ")
                + FormattableString.Invariant($"their object; {looked} free voxels looked at, {seen} seen, {differ} differ; {fill:0.0} ms")
        );
        Assert.True(hits > 500 && seen > 500, "Too few voxels have surfaces, or are seen.");
        Assert.Equal((0, 0), (wrong, wrongClass));
        Assert.InRange(differ, 0, (1 - MinVisible) * looked);

        double Across() => 0.98 * (random.NextDouble() - 0.5);

        Vector3D PointOf(Vector3D place) => grid.PointAt(place.X, place.Y, place.Z);
    }
}
