using Harvester.Capture.Events;
using Harvester.Geometry;

namespace Harvester.Capture.Tests.Events;

public class GroundMotionTests
{
    private const double Horizon = 1.5;

    [Fact]
    public void Gap_of_rectangles_is_the_least_distance_of_their_points()
    {
        var random = new Random(1);
        for (int i = 0; i < 300; i++)
        {
            BodyBox a = RandomBox(random, 0);
            BodyBox b = RandomBox(random, 6);
            Vector2D[] ofA = PointsOf(a);
            Vector2D[] ofB = PointsOf(b);
            double least = ofA.Min(p => ofB.Min(q => (p - q).Length));

            // Points lie 1/20 of a side of at most 6 m apart.
            Assert.InRange(a.Gap(b), least - 0.45, least + 1e-9);
            Assert.Equal(a.Gap(b), b.Gap(a), 9);
        }
    }

    [Fact]
    public void Time_to_collision_is_the_first_moment_without_a_gap()
    {
        var random = new Random(2);
        int hits = 0;
        for (int i = 0; i < 300; i++)
        {
            GroundMotion a = RandomMotion(random, 0);
            GroundMotion b = RandomMotion(random, 15);
            double? first = null;
            for (double time = 0; time <= Horizon && first is null; time += 0.0005)
            {
                first = a.After(time).Gap(b.After(time)) <= 0.001 ? time : null;
            }

            double? found = a.TimeToCollision(b, Horizon);
            hits += first is null ? 0 : 1;
            if (first is { } expected && expected < Horizon - 0.002)
            {
                Assert.NotNull(found);
                Assert.Equal(expected, found.Value, 0.002);
            }
            else if (first is null && found is not null)
            {
                Assert.InRange(found.Value, Horizon - 0.002, Horizon);
            }
        }

        Assert.InRange(hits, 20, 280);
    }

    [Fact]
    public void After_a_quarter_turn_a_body_is_on_its_circle()
    {
        // 10 m/s and π/4 rad/s: a circle of radius 40/π m around a place to the left.
        var box = new BodyBox(new Vector2D(0, 0), new Vector2D(0, 1), 2, 1, 0, 1);
        BodyBox after = new GroundMotion(box, new Vector2D(0, 0), new Vector2D(0, 10), Math.PI / 4).After(2);

        Assert.Equal(-40 / Math.PI, after.Centre.X, 9);
        Assert.Equal(40 / Math.PI, after.Centre.Y, 9);
        Assert.Equal(-1, after.Forward.X, 9);
    }

    [Fact]
    public void Common_place_of_overlapping_rectangles_lies_in_both()
    {
        var a = new BodyBox(new Vector2D(0, 0), new Vector2D(0, 1), 2, 1, 0, 1);
        var b = new BodyBox(new Vector2D(0, 3), new Vector2D(0, 1), 2, 1, 0, 1);

        Vector2D place = a.Common(b);

        Assert.Equal(0, place.X, 9);
        Assert.Equal(1.5, place.Y, 9);
    }

    [Fact]
    public void Impulse_lies_within_what_both_masses_allow()
    {
        var fair = ImpulseEstimate.Of(Sessions.Scenes.ObjectClass.Car, 5, Sessions.Scenes.ObjectClass.Car, 5);
        var unequal = ImpulseEstimate.Of(Sessions.Scenes.ObjectClass.Car, 0.1, Sessions.Scenes.ObjectClass.Pedestrian, 8);
        var contradicting = ImpulseEstimate.Of(Sessions.Scenes.ObjectClass.Car, 8, Sessions.Scenes.ObjectClass.Pedestrian, 0.1);

        Assert.Equal((7_500, 3_500, 17_500), (fair.Usual, fair.Min, fair.Max));
        Assert.Equal((160, 350), (unequal.Min, unequal.Max));
        Assert.Equal((2, 28_000), (contradicting.Min, contradicting.Max));
    }

    private static BodyBox RandomBox(Random random, double away)
    {
        double heading = random.NextDouble() * 2 * Math.PI;
        return new BodyBox(
            new Vector2D((random.NextDouble() * 6) + away, random.NextDouble() * 6),
            new Vector2D(Math.Sin(heading), Math.Cos(heading)),
            0.5 + (2.5 * random.NextDouble()),
            0.3 + random.NextDouble(),
            0,
            2
        );
    }

    private static GroundMotion RandomMotion(Random random, double away)
    {
        BodyBox box = RandomBox(random, away);
        return new GroundMotion(
            box,
            box.Centre - (box.Forward * 0.3),
            new Vector2D((random.NextDouble() - 0.5) * 30, (random.NextDouble() - 0.5) * 12),
            random.Next(3) == 0 ? 0 : random.NextDouble() - 0.5
        );
    }

    /// <summary>Points in a grid over a rectangle, with its edges.</summary>
    private static Vector2D[] PointsOf(BodyBox box) =>
        [
            .. from along in Enumerable.Range(0, 21)
            from across in Enumerable.Range(0, 21)
            select box.Centre
                + (box.Forward * (box.HalfLength * ((along / 10.0) - 1)))
                + (box.Right * (box.HalfWidth * ((across / 10.0) - 1))),
        ];
}
