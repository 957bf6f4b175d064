using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Labelling;

public sealed class FrameDraftTests : IRayCaster
{
    private static readonly HarvestOptions Options = new()
    {
        Image = new ImageSize(64, 48),
        Masks = true,
        RangeMetres = 100,
    };

    [Fact]
    public void Targets_are_the_candidates_numbered_from_one()
    {
        FrameDraft frame = Prepared(out _);

        Assert.Equal([20, 21], frame.Candidates.Select(candidate => candidate.Entity.Handle));
        Assert.Equal([(20, 1), (21, 2)], frame.Targets.Select(target => (target.Entity, (int)target.Number)));
        Assert.Equal(frame.Candidates.Select(candidate => candidate.Projection), frame.Targets.Select(target => target.Projection));
        Assert.Same(frame.Targets, frame.Targets);
    }

    [Fact]
    public void Labels_are_those_of_the_prepared_candidates()
    {
        // What the snapshot says is not looked at a second time: a candidate that is taken away has no label.
        FrameDraft frame = Prepared(out FrameLabeller labeller);
        frame.Candidates.RemoveAt(0);
        WorkRun.Complete(labeller.Label(frame, static () => true));

        Assert.Equal(21, Assert.Single(frame.Occlusions).Handle);
    }

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => null;

    private FrameDraft Prepared(out FrameLabeller labeller)
    {
        EntityState[] cars = [Car(20, -2), Car(21, 2)];
        labeller = new FrameLabeller(Options, new FrameRays(this, Options.RayBudget), new ObjectRegistry(1));
        var snapshot = new SceneSnapshot(
            1,
            0,
            new CameraState(new Pose(Vector3D.Zero, Axes.Identity), 60, 0.15, 4.0 / 3),
            new EgoState(1, "ego", default, default),
            cars,
            new EnvironmentState("clear", TimeSpan.Zero)
        );
        Camera camera = labeller.CameraOf(snapshot);
        return new FrameDraft(snapshot, camera, labeller.CandidatesOf(camera, snapshot));
    }

    private static EntityState Car(int handle, double east) =>
        new(
            handle,
            ObjectClass.Car,
            "box",
            new Pose(new Vector3D(east, 10, 0), Axes.Identity),
            new Vector3D(-1, -1, -1),
            new Vector3D(1, 1, 1),
            default
        );
}
