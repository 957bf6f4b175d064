namespace Harvester.Geometry.Tests.Scenes;

/// <summary>Draws the entities of <see cref="TownScene"/>: shapes of several convex parts, at places where traffic is found.</summary>
internal static class TownTraffic
{
    public static SolidThing Draw(Random random, int entity)
    {
        double kind = random.NextDouble();
        return kind switch
        {
            < 0.45 => Car(entity, OnRoad(random), random.Between(0.9, 1.1)),
            < 0.53 => Van(entity, OnRoad(random)),
            < 0.58 => Bus(entity, OnRoad(random)),
            < 0.65 => Motorcycle(entity, OnRoad(random)),
            < 0.85 => Pedestrian(entity, OnPavement(random), random.Between(0.85, 1.1), random.Between(0, 0.35)),
            _ => Sign(entity, OnPavement(random), random.Between(0.3, 0.45)),
        };
    }

    private static Pose OnRoad(Random random)
    {
        double x = new[] { -5.2, -1.8, 1.8, 5.2 }[random.Next(4)] + random.Between(-0.4, 0.4);
        double heading = (x < 0 ? 180 : 0) + (random.NextDouble() < 0.15 ? random.Between(-90, 90) : random.Between(-4, 4));
        return new Pose(new(x, Distance(random), 0), Axes.FromHeading(heading));
    }

    private static Pose OnPavement(Random random)
    {
        double x = (random.NextDouble() < 0.2 ? random.Between(-7, 7) : random.Between(7, 11)) * (random.Next(2) == 0 ? -1 : 1);
        return new Pose(new(x, Distance(random), 0), Axes.FromHeading(random.Between(0, 360)));
    }

    // More per metre nearby than far away would fill the image; more far away would all be specks.
    private static double Distance(Random random) => 5 + (115 * Math.Pow(random.NextDouble(), 1.3));

    private static SolidThing Car(int entity, Pose pose, double s) =>
        SolidThing.Build(
            entity,
            pose,
            (new(-0.9 * s, -2.2 * s, 0.25), new(0.9 * s, 2.2 * s, 0.85 * s), 0.96, 0.98),
            (new(-0.82 * s, -1.9 * s, 0.84 * s), new(0.82 * s, 1.0 * s, 1.42 * s), 0.75, 0.6),
            Wheel(-0.9 * s, 1.4 * s),
            Wheel(0.7 * s, 1.4 * s),
            Wheel(-0.9 * s, -1.4 * s),
            Wheel(0.7 * s, -1.4 * s),
            (new(-1.05 * s, 0.75 * s, 0.85 * s), new(-0.8 * s, 0.9 * s, 1.0 * s), 1, 1),
            (new(0.8 * s, 0.75 * s, 0.85 * s), new(1.05 * s, 0.9 * s, 1.0 * s), 1, 1)
        );

    private static (Vector3D, Vector3D, double, double) Wheel(double x, double y) =>
        (new(x, y - 0.33, 0), new(x + 0.2, y + 0.33, 0.64), 1, 0.7);

    private static SolidThing Van(int entity, Pose pose) =>
        SolidThing.Build(
            entity,
            pose,
            (new(-1, -2.8, 0.35), new(1, 1.7, 2.4), 0.95, 0.98),
            (new(-0.98, 1.6, 0.35), new(0.98, 2.8, 1.4), 0.95, 0.7),
            Wheel(-1, 1.9),
            Wheel(0.8, 1.9),
            Wheel(-1, -1.8),
            Wheel(0.8, -1.8)
        );

    private static SolidThing Bus(int entity, Pose pose) =>
        SolidThing.Build(
            entity,
            pose,
            (new(-1.25, -5.8, 0.35), new(1.25, 5.8, 3.1), 0.97, 0.99),
            Wheel(-1.25, 3.6),
            Wheel(1.05, 3.6),
            Wheel(-1.25, -3.4),
            Wheel(1.05, -3.4)
        );

    private static SolidThing Motorcycle(int entity, Pose pose) =>
        SolidThing.Build(
            entity,
            pose,
            (new(-0.08, 0.4, 0), new(0.08, 1.0, 0.6), 1, 0.6),
            (new(-0.08, -1.0, 0), new(0.08, -0.4, 0.6), 1, 0.6),
            (new(-0.2, -0.8, 0.45), new(0.2, 0.6, 0.9), 0.8, 0.8),
            (new(-0.25, -0.4, 0.85), new(0.25, 0.1, 1.45), 0.8, 0.7),
            (new(-0.13, -0.2, 1.45), new(0.13, 0.06, 1.72), 0.8, 0.8),
            (new(-0.35, 0.35, 0.95), new(0.35, 0.45, 1.05), 1, 1)
        );

    private static SolidThing Pedestrian(int entity, Pose pose, double s, double stride) =>
        SolidThing.Build(
            entity,
            pose,
            (new(-0.2 * s, stride - 0.09, 0), new(-0.04 * s, stride + 0.12, 0.85 * s), 1, 1),
            (new(0.04 * s, -stride - 0.09, 0), new(0.2 * s, -stride + 0.12, 0.85 * s), 1, 1),
            (new(-0.25 * s, -0.14, 0.8 * s), new(0.25 * s, 0.14, 1.45 * s), 0.85, 0.9),
            (new(-0.1 * s, -0.1, 1.47 * s), new(0.1 * s, 0.1, 1.75 * s), 0.8, 0.8)
        );

    private static SolidThing Sign(int entity, Pose pose, double half) =>
        SolidThing.Build(
            entity,
            pose,
            (new(-0.04, -0.04, 0), new(0.04, 0.04, 2.2), 1, 1),
            (new(-half, -0.07, 2.1), new(half, -0.04, 2.1 + (2 * half)), 1, 1)
        );
}
