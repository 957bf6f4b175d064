using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Takes frames of a running game. The picture lag is known, so the state is read and labelled first, and the picture is grabbed when it
/// shows that state. Rays are cast in the tick in which the state was read, within its budget, and never later: objects that the budget
/// does not reach keep their boxes and have no occlusion.
/// </summary>
internal sealed class LiveFlow(
    GamePorts game,
    SceneReader reader,
    FrameLabeller labeller,
    PixelBufferPool pool,
    TickBudget budget,
    HarvestCounters counters,
    Func<PictureLag> nextLag
) : ICaptureFlow
{
    public IReadOnlyList<FrameDraft> Taken { get; private set; } = [];

    public bool IsPassed => false;

    public double? TakenSeconds { get; private set; }

    public IEnumerable<WorkStep> TakeFrame()
    {
        Taken = [];
        TakenSeconds = null;
        GrabbedPicture? picture = null;
        try
        {
            // The picture of tick g shows the entities of g - EntityTicks and the camera of g - CameraTicks; the earlier of both is tick 0.
            PictureLag lag = nextLag();
            int entityTick = Math.Max(0, lag.CameraTicks - lag.EntityTicks);
            int cameraTick = Math.Max(0, lag.EntityTicks - lag.CameraTicks);
            int grabTick = entityTick + lag.EntityTicks;
            int readTick = Math.Max(entityTick, cameraTick);
            long firstGameFrame = game.World.GameFrame;
            double grabSeconds = 0;
            SceneSnapshot? scene = null;
            CameraState? camera = null;
            FrameDraft? draft = null;
            for (int tick = 0; tick <= Math.Max(grabTick, readTick); tick++)
            {
                if (tick > 0)
                {
                    yield return HarvestPhase.Following.Tick();
                }

                if (game.World.GameFrame - firstGameFrame != tick)
                {
                    counters.Discard("tickMissed");
                    yield break;
                }

                if (tick == grabTick)
                {
                    grabSeconds = game.World.TimeSeconds;
                    picture = new GrabbedPicture(game.Screen, pool);
                    if (picture.Refusal is { } refusal)
                    {
                        counters.Discard(refusal);
                        yield break;
                    }
                }

                scene = tick == entityTick ? reader.Read() : scene;
                camera = tick == cameraTick ? game.World.ReadCamera() : camera;
                if (tick == readTick)
                {
                    scene = scene! with { Camera = camera! };
                    budget.BeginSteps();
                    draft = labeller.LabelAtOnce(scene, () => !budget.IsSpent);
                }
            }

            draft!.LagFrames = lag.EntityTicks;
            draft.LagSeconds = grabSeconds - draft.Snapshot.TimeSeconds;
            (draft.Picture, picture) = (picture, null);
            Taken = [draft];
            TakenSeconds = draft.Snapshot.TimeSeconds;
        }
        finally
        {
            picture?.Dispose();
        }
    }
}
