using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>A LiDAR on a moving car, in a court of four walls with a moving board.</summary>
public sealed class LidarMotionTests : IRayCaster
{
    private const int Columns = 8;
    private const int Board = 7;

    /// <summary>Points have single precision: seven digits of some 100 m.</summary>
    private const double Rounding = 2e-5;

    /// <summary>Half the side of the court, metres.</summary>
    private const double Wall = 50;

    private EntityState? _board;

    /// <summary>The walls are infinite planes; the board is a rectangle across the y axis.</summary>
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        double nearest = new[]
        {
            (Wall - ray.Origin.X) / ray.Direction.X,
            (-Wall - ray.Origin.X) / ray.Direction.X,
            (Wall - ray.Origin.Y) / ray.Direction.Y,
            (-Wall - ray.Origin.Y) / ray.Direction.Y,
        }
            .Where(distance => distance > 0)
            .Min();
        if (_board is { } board)
        {
            double distance = (board.Pose.Position.Y - ray.Origin.Y) / ray.Direction.Y;
            Vector3D at = ray.At(distance);
            if (distance > 0 && distance < Math.Min(nearest, maxDistance) && Math.Abs(at.X - board.Pose.Position.X) <= 1)
            {
                return new RayHit(distance, Board);
            }
        }

        return nearest <= maxDistance ? new RayHit(nearest, RayHit.World) : null;
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.7)]
    [InlineData(-1.2)]
    public void Points_are_seen_from_where_the_sensor_was(double yawRate)
    {
        var velocity = new Vector3D(3, 20, 0);
        LidarPoint[] points = Scan(
            new EgoState(1, "car", new Pose(new Vector3D(4, 5, 1), Axes.Identity), velocity) { Motion = new EgoMotion(yawRate, 0) }
        );

        Assert.Equal(Columns, points.Length);
        foreach (LidarPoint point in points)
        {
            // Back from the moment in small steps: the car turns, and its velocity with it.
            double seconds = (Columns - 1 - point.Column) / (Columns * 10.0);
            const int steps = 100_000;
            double x = 4;
            double y = 5;
            for (int i = 0; i < steps; i++)
            {
                double middle = -yawRate * seconds * (i + 0.5) / steps;
                x -= ((Math.Cos(middle) * velocity.X) - (Math.Sin(middle) * velocity.Y)) * seconds / steps;
                y -= ((Math.Sin(middle) * velocity.X) + (Math.Cos(middle) * velocity.Y)) * seconds / steps;
            }

            // The sensor is 1 m ahead of the car's origin and looks along it.
            double heading = -yawRate * seconds;
            double ahead = 1 + point.Y;
            double worldX = x + (Math.Cos(heading) * point.X) - (Math.Sin(heading) * ahead);
            double worldY = y + (Math.Sin(heading) * point.X) + (Math.Cos(heading) * ahead);
            Assert.InRange(Math.Max(Math.Abs(worldX), Math.Abs(worldY)), Wall - Rounding, Wall + Rounding);

            double azimuth = Math.Atan2(point.X, point.Y) * 180 / Math.PI;
            Assert.InRange(Math.IEEERemainder(azimuth - ((45 * point.Column) - 180), 360), -Rounding, Rounding);
        }
    }

    [Fact]
    public void Moving_object_is_met_where_it_was()
    {
        // Column 4 of 8 looks ahead, three columns of 1/80 s before the end. The board goes 10 m/s ahead, the car follows with 15 m/s: then
        // the board was at 30 - 0.375 and the sensor at 1 - 0.5625.
        _board = BoardAt(new Vector3D(0, 30, 0), new Vector3D(0, 10, 0));
        LidarPoint ahead = Scan(Ego(new Vector3D(0, 15, 0)))[4];

        Assert.InRange(ahead.Y, 30 - 0.375 - 1 + 0.5625 - Rounding, 30 - 0.375 - 1 + 0.5625 + Rounding);
    }

    [Fact]
    public void Object_that_was_elsewhere_hides_nothing()
    {
        // It crosses at 60 m/s and was 2.25 m to the left, so that the ray passes its right edge and meets the wall.
        _board = BoardAt(new Vector3D(0, 30, 0), new Vector3D(60, 0, 0));
        LidarPoint ahead = Scan(Ego(Vector3D.Zero))[4];

        Assert.InRange(ahead.Y, Wall - 1 - Rounding, Wall - 1 + Rounding);
    }

    [Fact]
    public void Object_that_has_left_the_ray_is_still_met()
    {
        _board = BoardAt(new Vector3D(2.25, 30, 0), new Vector3D(60, 0, 0));
        LidarPoint ahead = Scan(Ego(Vector3D.Zero))[4];

        Assert.InRange(ahead.Y, 29 - Rounding, 29 + Rounding);
    }

    private static EgoState Ego(Vector3D velocity) => new(1, "car", new Pose(Vector3D.Zero, Axes.Identity), velocity);

    private static EntityState BoardAt(Vector3D position, Vector3D velocity) =>
        new(Board, ObjectClass.Car, "board", new Pose(position, Axes.Identity), new Vector3D(-1, 0, -1), new Vector3D(1, 0, 1), velocity);

    private LidarPoint[] Scan(EgoState ego)
    {
        var lidar = new RigLidar("top", new Pose(new Vector3D(0, 1, 0), Axes.Identity), [0], Columns, 10, 0.5, 200)
        {
            MotionDistortion = true,
        };
        var game = new GamePorts(null!, this, null!, null!, null!);
        var moment = new SceneSnapshot(
            1,
            0,
            new CameraState(ego.Pose, 50, 1.5, 0.1),
            ego,
            _board is null ? [] : [_board],
            new EnvironmentState("clear", TimeSpan.Zero)
        );
        var scanner = new LidarScanner(lidar, lidar.Mount, new LabellingOptions(), game, new ObjectRegistry(1));
        var sweep = new WorkResult<LidarSweep>();
        WorkRun.Complete(scanner.Scan(moment, sweep));
        return [.. sweep.Value!.Points];
    }
}
