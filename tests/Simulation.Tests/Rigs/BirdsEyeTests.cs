using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Tests.Labelling;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>
/// Bird's-eye maps compared with a picture of the static world from above, with the ground truth of lanes, with the boxes of entities, and
/// with rays from the camera.
/// </summary>
public sealed class BirdsEyeTests(ITestOutputHelper output)
{
    /// <summary>
    /// The picture shows a cell by a pixel this close to its middle, cells: 1 cm. The pixels around it, 3.5 cm away, show the same, so that
    /// no edge lies between.
    /// </summary>
    private const double NearMiddle = 0.04;

    /// <summary>Lanes end, on the facets of a road, beside the places on their curve by up to this, metres.</summary>
    private const double LaneTolerance = 0.1;

    /// <summary>The middle of a cell this close to a side of a box, metres, may be judged either way: rounding.</summary>
    private const double BoxTolerance = 1e-6;

    /// <summary>A ray that ends this close to the ground of a cell sees it, metres: facets are as close to the plane of the cell.</summary>
    private const double RayTolerance = 0.1;

    /// <summary>
    /// The part of the cells whose visibility must agree with rays: pixels are larger than cells far away, so that at the border of what
    /// hides the ground a pixel and a ray may differ.
    /// </summary>
    private const double MinVisible = 0.97;

    /// <summary>The part of drivable cells that lanes of the road data must cover in common with the exact map, and the reverse.</summary>
    private const double MinOfRoads = 0.5;

    private static readonly ImageSize Image = new(400, 300);
    private static readonly GridShape Shape = new(60, 0.25);

    [Fact]
    public void The_ground_is_that_of_a_picture_from_above() => Judge(61, JudgeGround);

    [Fact]
    public void Vehicles_and_people_are_the_outlines_of_their_boxes() => Judge(62, JudgeBodies);

    /// <summary>Seeds that were used while this was built, or others for figures.</summary>
    public static TheoryData<int> Seeds =>
        [
            .. (Environment.GetEnvironmentVariable("GTADATAHARVESTER_BIRDS_EYE_SEEDS") ?? "63 64 65")
                .Split(' ')
                .Select(text => int.Parse(text, CultureInfo.InvariantCulture)),
        ];

    [Theory]
    [MemberData(nameof(Seeds))]
    [Trait("Category", "Heavy")]
    public void Maps_of_further_seeds_agree_too(int seed) =>
        Judge(
            seed,
            (game, part, label) =>
            {
                JudgeGround(game, part, label);
                JudgeLanes(game, part, label);
                JudgeBodies(game, part, label);
                JudgeVisible(game, part, label);
            }
        );

    [Fact]
    public void Roads_alone_give_lanes_and_junctions()
    {
        BirdsEyeClass[]? exact = null;
        Judge(66, (_, part, _) => exact = [.. part.Classes]);
        Judge(
            66,
            (_, part, label) =>
            {
                Assert.Equal((BirdsEyeSource.Roads, null), (label.Source, label.Visible));
                (int both, int either) = (0, 0);
                for (int cell = 0; cell < exact!.Length; cell++)
                {
                    (bool one, bool other) = (IsLane(exact[cell]), IsLane(part.Classes[cell]));
                    both += one && other ? 1 : 0;
                    either += one || other ? 1 : 0;
                }

                output.WriteLine(FormattableString.Invariant($"lanes of roads: intersection over union {both / (double)either:0.000}"));
                Assert.InRange(both / (double)either, MinOfRoads, 1);
            },
            static game => game.Ports with { Ground = null, Surfaces = null, Roads = new FixedRoads(game.Roads, "simulation") }
        );
    }

    private static bool IsLane(BirdsEyeClass kind) => kind is BirdsEyeClass.Lane or BirdsEyeClass.Line;

    private static void Judge(
        int seed,
        Action<SimulatedGame, BirdsEyePart, BirdsEyeLabel> judge,
        Func<SimulatedGame, GamePorts>? portsOf = null
    )
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = seed });
        HarvestOptions options = new()
        {
            Image = Image,
            MaxFrames = 1,
            Channels = new ChannelKeys(["birdsEye"]),
            BirdsEye = Shape,
        };
        LabelledTown.Harvest(
            game,
            portsOf?.Invoke(game) ?? game.Ports,
            options,
            (frame, _) => judge(game, frame.Part<BirdsEyePart>()!, frame.Label.Channels.Get<BirdsEyeLabel>()!)
        );
    }

    /// <summary>Draws the static world from 100 m above the ego and compares the pixels near the middles of cells.</summary>
    private void JudgeGround(SimulatedGame game, BirdsEyePart part, BirdsEyeLabel label)
    {
        const double height = 100;
        const int side = 1800;
        Assert.Equal((240, 0.25, BirdsEyeSource.Exact), (label.Cells, label.CellMetres, label.Source));
        Pose ego = game.Shown.Ego.Pose;
        Vector3D ahead = (ego.Axes.Forward with { Z = 0 }).Normalized();
        var right = new Vector3D(ahead.Y, -ahead.X, 0);
        var camera = new RenderCamera(
            new Pose(ego.Position + new Vector3D(0, 0, height), Axes.FromVectors(right, new Vector3D(0, 0, -1), ahead)),
            2 * Math.Atan(32 / height) * 180 / Math.PI,
            1,
            0.5,
            side,
            side
        );
        var picture = new RenderTarget(side, side);
        var bare = new RenderScene(game.World.Scene, []);
        new Renderer().Render(bare, camera, picture);
        (int compared, int wrong) = (0, 0);
        var kinds = new Dictionary<SurfaceKind, int>();
        var mistakes = new Dictionary<(SurfaceKind, BirdsEyeClass), int>();
        double perMetre = side / (2 * 32 / height);
        for (int row = 1; row < side - 1; row++)
        {
            for (int column = 1; column < side - 1; column++)
            {
                int at = (row * side) + column;
                SurfaceKind kind = picture.Kinds[at];
                bool isBorder = false;
                for (int beside = -1; beside <= 1; beside++)
                {
                    for (int above = -side; above <= side; above += side)
                    {
                        isBorder |= picture.Kinds[at + beside + above] != kind || picture.Handles[at + beside + above] != 0;
                    }
                }

                // The point that the pixel shows, metres to the right and ahead of the ego, and its cell.
                double depth = picture.Depth[at];
                double x = ((column + 0.5 - (side / 2.0)) / perMetre * depth / Shape.CellMetres) + 120;
                double y = ((row + 0.5 - (side / 2.0)) / perMetre * depth / Shape.CellMetres) + 120;
                (int cellColumn, int cellRow) = ((int)Math.Floor(x), (int)Math.Floor(y));
                if (
                    isBorder
                    || cellColumn is < 0 or >= 240
                    || cellRow is < 0 or >= 240
                    || Math.Abs(x - cellColumn - 0.5) > NearMiddle
                    || Math.Abs(y - cellRow - 0.5) > NearMiddle
                    || Expected(kind) is not { } expected
                )
                {
                    continue;
                }

                BirdsEyeClass found = part.Classes[(cellRow * 240) + cellColumn];
                if (found is BirdsEyeClass.Vehicle or BirdsEyeClass.Person)
                {
                    continue;
                }

                compared++;
                kinds[kind] = kinds.GetValueOrDefault(kind) + 1;
                if (!expected.Contains(found))
                {
                    wrong++;
                    mistakes[(kind, found)] = mistakes.GetValueOrDefault((kind, found)) + 1;
                }
            }
        }

        output.WriteLine(
            $"ground: {wrong} of {compared} pixels wrong; " + string.Join(", ", kinds.Select(each => $"{each.Key} {each.Value}"))
        );
        output.WriteLine(string.Join(", ", mistakes.Select(each => $"{each.Key.Item1} as {each.Key.Item2} {each.Value}")));
        Assert.True(kinds.GetValueOrDefault(SurfaceKind.Road) > 1000 && kinds.GetValueOrDefault(SurfaceKind.Marking) > 100);
        Assert.Equal(0, wrong);
    }

    private static BirdsEyeClass[]? Expected(SurfaceKind kind) =>
        kind switch
        {
            SurfaceKind.Road => [BirdsEyeClass.Drivable, BirdsEyeClass.Lane, BirdsEyeClass.Crossing],
            SurfaceKind.Marking => [BirdsEyeClass.Line, BirdsEyeClass.Crossing],
            SurfaceKind.Pavement or SurfaceKind.Terrain => [BirdsEyeClass.Other],
            _ => null,
        };

    /// <summary>Outside junctions, a drivable cell is a lane where the position on the road is that of a lane.</summary>
    private void JudgeLanes(SimulatedGame game, BirdsEyePart part, BirdsEyeLabel label)
    {
        (int compared, int wrong) = (0, 0);
        double ground = game.Shown.Ego.Pose.Position.Z;
        for (int cell = 0; cell < part.Classes.Count; cell++)
        {
            BirdsEyeClass found = part.Classes[cell];
            if (found is not (BirdsEyeClass.Drivable or BirdsEyeClass.Lane))
            {
                continue;
            }

            Vector3D place = PlaceOf(game, cell) with { Z = ground };
            // Where a lane begins or ends, and in junctions, the position a little farther says something else.
            bool?[] around =
            [
                .. new[] { (0, 0), (1, 0), (-1, 0), (0, 1), (0, -1) }.Select(way =>
                    IsOnLane(game, place + new Vector3D(way.Item1 * LaneTolerance, way.Item2 * LaneTolerance, 0))
                ),
            ];
            if (around[0] is { } isLane && around.All(each => each == isLane))
            {
                compared++;
                wrong += isLane == (found == BirdsEyeClass.Lane) ? 0 : 1;
            }
        }

        output.WriteLine($"lanes: {wrong} of {compared} cells wrong");
        Assert.True(compared > 1000, $"Only {compared} cells were compared.");
        Assert.Equal(0, wrong);
    }

    /// <summary>Whether a place outside junctions is that of a lane in any direction; null in a junction and off the road.</summary>
    private static bool? IsOnLane(SimulatedGame game, Vector3D place)
    {
        LanePosition[] positions =
        [
            .. Enumerable.Range(0, 4).Select(turn => game.Truth.Locate(place, Axes.FromHeading(90 * turn).Forward)).OfType<LanePosition>(),
        ];
        return positions.Length == 0 || positions.Any(position => position.IsInJunction)
            ? null
            : positions.Any(position => position.Lane is not null);
    }

    /// <summary>A cell shows a vehicle or person where its middle is within the outline of the corners of a box.</summary>
    private void JudgeBodies(SimulatedGame game, BirdsEyePart part, BirdsEyeLabel label)
    {
        (Vector2D[] Corners, bool IsPerson)[] bodies =
        [
            .. game
                .Shown.Entities.Where(entity => entity.Class is not (ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Other))
                .Select(entity => (CornersOf(entity), entity.Class is ObjectClass.Pedestrian or ObjectClass.Rider)),
        ];
        (int vehicles, int people) = (0, 0);
        for (int cell = 0; cell < part.Classes.Count; cell++)
        {
            Vector3D place = PlaceOf(game, cell);
            var middle = new Vector2D(place.X, place.Y);
            (bool isPerson, bool isVehicle, bool isUnclear) = (false, false, false);
            foreach ((Vector2D[] corners, bool person) in bodies)
            {
                if ((corners[0] - middle).Length > 30)
                {
                    continue;
                }

                double within = WithinHull(corners, middle);
                isUnclear |= Math.Abs(within) < BoxTolerance;
                isPerson |= person && within > 0;
                isVehicle |= !person && within > 0;
            }

            if (!isUnclear)
            {
                BirdsEyeClass found = part.Classes[cell];
                Assert.Equal(isPerson, found == BirdsEyeClass.Person);
                Assert.Equal(isVehicle && !isPerson, found == BirdsEyeClass.Vehicle);
                vehicles += isVehicle ? 1 : 0;
                people += isPerson ? 1 : 0;
            }
        }

        output.WriteLine($"bodies: {vehicles} cells of vehicles and {people} of people, all right");
        Assert.True(vehicles > 100, $"Only {vehicles} cells of vehicles.");
    }

    /// <summary>The ground of a cell is seen where a ray from the camera to it meets nothing before.</summary>
    private void JudgeVisible(SimulatedGame game, BirdsEyePart part, BirdsEyeLabel label)
    {
        SceneSnapshot shown = game.Shown;
        var camera = new Camera(
            shown.Camera.Pose,
            new CameraIntrinsics(shown.Camera.VerticalFovDegrees, Image, shown.Camera.WindowAspect, shown.Camera.NearClip, Lens.Ideal)
        );
        (int compared, int wrong, int seen) = (0, 0, 0);
        for (int cell = 0; cell < part.Classes.Count; cell++)
        {
            if (part.Classes[cell] is BirdsEyeClass.Vehicle or BirdsEyeClass.Person)
            {
                continue;
            }

            // The ground under the cell, by a ray from above that passes no roofs: it begins 4 m above the ego.
            Vector3D above = PlaceOf(game, cell) + new Vector3D(0, 0, 4);
            if (
                game.Ports.Rays.Cast(new Ray(above, new Vector3D(0, 0, -1)), 12, shown.Ego.Handle) is not { } down
                || down.Entity != RayHit.World
            )
            {
                continue;
            }

            Vector3D ground = above - new Vector3D(0, 0, down.Distance);
            Vector3D eye = camera.Pose.Position;
            bool isSeen =
                camera.Project(ground).Outcome == ProjectionOutcome.InImage
                && game.Ports.Rays.Cast(new Ray(eye, ground - eye), (ground - eye).Length - RayTolerance, shown.Ego.Handle) is null;
            compared++;
            seen += isSeen ? 1 : 0;
            wrong += isSeen == part.Visible![cell] ? 0 : 1;
        }

        output.WriteLine($"visible: {wrong} of {compared} cells differ, {seen} are seen");
        Assert.True(seen > 500, $"Only {seen} cells are seen.");
        Assert.InRange(1 - (wrong / (double)compared), MinVisible, 1);
    }

    /// <summary>The middle of a cell: columns to the right, rows from the front to the rear, the ego in the middle.</summary>
    private static Vector3D PlaceOf(SimulatedGame game, int cell)
    {
        Pose ego = game.Shown.Ego.Pose;
        double heading = Math.Atan2(ego.Axes.Forward.Y, ego.Axes.Forward.X);
        double right = ((cell % 240) + 0.5 - 120) * 0.25;
        double ahead = (120 - (cell / 240) - 0.5) * 0.25;
        return ego.Position
            + new Vector3D(
                (ahead * Math.Cos(heading)) + (right * Math.Sin(heading)),
                (ahead * Math.Sin(heading)) - (right * Math.Cos(heading)),
                0
            );
    }

    private static Vector2D[] CornersOf(EntityState entity) =>
        [
            .. Enumerable
                .Range(0, 8)
                .Select(number =>
                    entity.Pose.ToWorld(
                        new Vector3D(
                            number % 2 == 0 ? entity.ModelMin.X : entity.ModelMax.X,
                            number / 2 % 2 == 0 ? entity.ModelMin.Y : entity.ModelMax.Y,
                            number / 4 == 0 ? entity.ModelMin.Z : entity.ModelMax.Z
                        )
                    )
                )
                .Select(corner => new Vector2D(corner.X, corner.Y)),
        ];

    /// <summary>How far a point is inside the outline of others; negative outside.</summary>
    private static double WithinHull(Vector2D[] corners, Vector2D point)
    {
        double within = double.PositiveInfinity;
        foreach (Vector2D from in corners)
        {
            foreach (Vector2D to in corners)
            {
                Vector2D edge = to - from;
                if (edge.Length > BoxTolerance && corners.All(other => edge.Cross(other - from) / edge.Length > -BoxTolerance))
                {
                    within = Math.Min(within, edge.Cross(point - from) / edge.Length);
                }
            }
        }

        return within;
    }
}
