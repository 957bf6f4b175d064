using Harvester.Capture.Harvesting;
using Harvester.Capture.Scenes;
using Harvester.Geometry;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>Records are written as rows: the place of the camera, the place of the entity, the change of the picture.</summary>
public sealed class LagRecordTests
{
    [Fact]
    public void Lag_is_from_the_first_standing_state_to_the_last_change_of_the_picture()
    {
        // The state stands from tick 2 on, the picture from tick 4 on.
        LagRecord record = Record((0, 0, 9), (1, 1, 9), (2, 2, 9), (2, 2, 9), (2, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0));

        Assert.Equal(new PictureLag(2, 2), record.Lag);
    }

    [Fact]
    public void Lag_of_a_camera_reported_late_is_one_less()
    {
        LagRecord record = Record((0, 0, 9), (0, 1, 9), (1, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0), (2, 2, 0));

        Assert.Equal(new PictureLag(-1, 0), record.Lag);
    }

    [Fact]
    public void Lag_with_grain_in_the_picture_is_that_of_the_movement()
    {
        LagRecord record = Record((0, 0, 9), (1, 1, 8), (2, 2, 9), (2, 2, 7), (2, 2, 1), (2, 2, 1.2), (2, 2, 0.9), (2, 2, 1.1));

        Assert.Equal(new PictureLag(1, 1), record.Lag);
    }

    [Fact]
    public void Lag_is_unknown_when_the_camera_stood_all_the_time() =>
        Assert.Null(Record((2, 0, 9), (2, 1, 9), (2, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0)).Lag);

    [Fact]
    public void Lag_is_unknown_when_the_picture_never_changed() =>
        Assert.Null(Record((0, 0, 0), (1, 1, 0), (2, 2, 0), (2, 2, 0), (2, 2, 0), (2, 2, 0)).Lag);

    [Fact]
    public void Lag_is_unknown_when_the_picture_never_stood() =>
        Assert.Null(Record((0, 0, 9), (1, 1, 9), (2, 2, 9), (2, 2, 9), (2, 2, 9), (2, 2, 9)).Lag);

    [Fact]
    public void Lag_is_unknown_when_a_picture_was_refused() =>
        Assert.Null(Record((0, 0, 9), (1, 1, 9), (2, 2, double.NaN), (2, 2, 0), (2, 2, 0), (2, 2, 0)).Lag);

    [Fact]
    public void Lag_is_unknown_when_a_game_frame_was_missed()
    {
        LagRecord record = Record((0, 0, 9), (1, 1, 9), (2, 2, 9), (2, 2, 0), (2, 2, 0), (2, 2, 0));
        record.Add(State(7, 2, 2), 0);

        Assert.Null(record.Lag);
    }

    private static LagRecord Record(params (double Camera, double Entity, double Change)[] rows)
    {
        var record = new LagRecord(new SceneComparison(0.001));
        for (int i = 0; i < rows.Length; i++)
        {
            record.Add(State(i, rows[i].Camera, rows[i].Entity), rows[i].Change);
        }

        return record;
    }

    private static SceneSnapshot State(long gameFrame, double camera, double entity)
    {
        var car = new EntityState(
            1, ObjectClass.Car, "asea", new Pose(new Vector3D(0, entity, 0), Axes.Identity), new Vector3D(-1, -2, 0), new Vector3D(1, 2, 1), Vector3D.Zero);
        return new SceneSnapshot(
            gameFrame, 0,
            new CameraState(new Pose(new Vector3D(0, camera, 0), Axes.Identity), 50, 0.15, 1),
            new EgoState(7, "blista", new Pose(Vector3D.Zero, Axes.Identity), Vector3D.Zero),
            [car],
            new EnvironmentState("clear", TimeSpan.Zero));
    }
}
