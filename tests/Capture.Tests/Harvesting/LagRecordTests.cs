using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>Records are written as rows: the place of the camera, the place of the entity, the change of the picture.</summary>
public sealed class LagRecordTests
{
    private const int MaxTicks = 4;
    private const int RunningTicks = 2;

    [Fact]
    public void Lag_is_the_shift_from_the_movement_to_the_pictures()
    {
        // The state stands from tick 2 on, the picture from tick 4 on.
        LagRecord record = Record((0, 0, 9), (1, 1, 9), (2, 2, 9), (2, 2, 9), (2, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0), (2, 2, 0));

        Assert.Equal(new PictureLag(2, 2), Lag(record));
    }

    [Fact]
    public void Lag_of_a_camera_reported_late_is_smaller_by_one()
    {
        LagRecord record = Record((-1, 0, 9), (0, 1, 9), (1, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0), (2, 2, 0));

        Assert.Equal(new PictureLag(-1, 0), Lag(record));
    }

    [Fact]
    public void Lag_is_measured_from_movement_despite_image_noise()
    {
        LagRecord record = Record((0, 0, 9), (1, 1, 8), (2, 2, 9), (2, 2, 7), (2, 2, 1), (2, 2, 1.2), (2, 2, 0.9), (2, 2, 1.1));

        Assert.Equal(new PictureLag(1, 1), Lag(record));
    }

    [Fact]
    public void Lag_in_a_creeping_world_is_measured_from_the_freeze()
    {
        // Creep from tick 3 to 5, pictures two ticks later: 5 to 7.
        LagRecord record = Record(
            (0, 0, 9),
            (1, 1, 9),
            (2, 2, 9),
            (2.1, 2.1, 8),
            (2.2, 2.2, 9),
            (2.3, 2.3, 2),
            (2.3, 2.3, 3),
            (2.3, 2.3, 2.5),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0)
        );

        Assert.Equal(new PictureLag(2, 2), Lag(record));
    }

    [Fact]
    public void Lag_in_an_invisibly_creeping_world_is_that_of_the_freeze()
    {
        LagRecord record = Record(
            (0, 0, 9),
            (1, 1, 9),
            (2, 2, 9),
            (2.1, 2.1, 8),
            (2.2, 2.2, 9),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0),
            (2.3, 2.3, 0)
        );

        Assert.Equal(new PictureLag(2, 2), Lag(record));
    }

    [Fact]
    public void Lag_is_not_overestimated_by_creep_below_the_tolerance()
    {
        // 0.2 mm a tick where the running game takes 5 mm; the pictures show it.
        LagRecord record = Record(
            (0, 0, 9),
            (0.005, 0.005, 9),
            (0.01, 0.01, 9),
            (0.0102, 0.0102, 9),
            (0.0104, 0.0104, 1),
            (0.0104, 0.0104, 1),
            (0.0104, 0.0104, 0),
            (0.0104, 0.0104, 0),
            (0.0104, 0.0104, 0)
        );

        Assert.Equal(new PictureLag(1, 1), Lag(record));
    }

    [Fact]
    public void Lag_is_unknown_when_the_pictures_do_not_follow_the_movement() =>
        Assert.Null(
            Lag(Record((0, 0, 9), (1, 1, 9), (2, 2, 9), (2, 2, 0), (2, 2, 9), (2, 2, 0), (2, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0)))
        );

    [Fact]
    public void Lag_is_unknown_when_the_camera_never_moved() =>
        Assert.Null(Lag(Record([.. Running.Select(_ => 2.0)], (2, 0, 9), (2, 1, 9), (2, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0))));

    [Fact]
    public void Lag_is_unknown_when_the_picture_never_changed() =>
        Assert.Null(Lag(Record((0, 0, 0), (1, 1, 0), (2, 2, 0), (2, 2, 0), (2, 2, 0), (2, 2, 0))));

    [Fact]
    public void Lag_is_unknown_when_the_picture_never_settled() =>
        Assert.Null(Lag(Record((0, 0, 9), (1, 1, 9), (2, 2, 9), (2, 2, 9), (2, 2, 9), (2, 2, 9))));

    [Fact]
    public void Lag_is_unknown_when_a_picture_was_refused() =>
        Assert.Null(Lag(Record((0, 0, 9), (1, 1, 9), (2, 2, double.NaN), (2, 2, 0), (2, 2, 0), (2, 2, 0))));

    [Fact]
    public void Lag_is_unknown_when_a_game_frame_was_missed()
    {
        LagRecord record = Record((0, 0, 9), (1, 1, 9), (2, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0));
        record.Add(State(7, 2, 2), 0);

        Assert.Null(Lag(record));
    }

    private static IEnumerable<int> Running => Enumerable.Range(-MaxTicks - 1, MaxTicks + 1);

    private static PictureLag? Lag(LagRecord record) => record.LagOf(RunningTicks, MaxTicks);

    private static LagRecord Record(params (double Camera, double Entity, double Change)[] rows)
    {
        // All moves before the rows as it does in the first two of them.
        double step = rows[1].Entity - rows[0].Entity;
        return Record([.. Running.Select(tick => rows[0].Camera + (tick * step))], rows);
    }

    private static LagRecord Record(double[] cameraBefore, params (double Camera, double Entity, double Change)[] rows)
    {
        var record = new LagRecord();
        double step = rows[1].Entity - rows[0].Entity;
        int tick = -cameraBefore.Length;
        foreach (double camera in cameraBefore)
        {
            record.Add(State(tick, camera, rows[0].Entity + (tick * step)));
            tick++;
        }

        for (int i = 0; i < rows.Length; i++)
        {
            record.Add(State(i, rows[i].Camera, rows[i].Entity), rows[i].Change);
        }

        return record;
    }

    private static SceneSnapshot State(long gameFrame, double camera, double entity)
    {
        var car = new EntityState(
            1,
            ObjectClass.Car,
            "asea",
            new Pose(new Vector3D(0, entity, 0), Axes.Identity),
            new Vector3D(-1, -2, 0),
            new Vector3D(1, 2, 1),
            Vector3D.Zero
        );
        return new SceneSnapshot(
            gameFrame,
            0,
            new CameraState(new Pose(new Vector3D(0, camera, 0), Axes.Identity), 50, 0.15, 1),
            new EgoState(7, "blista", new Pose(Vector3D.Zero, Axes.Identity), Vector3D.Zero),
            [car],
            new EnvironmentState("clear", TimeSpan.Zero)
        );
    }
}
