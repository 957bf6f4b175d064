using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;

namespace Harvester.Simulation.Tests.Flow;

/// <summary>A harvest of flow, with the moments that its pictures show.</summary>
internal sealed class FlowHarvest
{
    public int Seed { get; init; }

    public ImageSize Image { get; init; }

    public RenderLens Lens { get; init; } = RenderLens.None;

    public int Frames { get; init; } = 2;

    /// <summary>The faults of the game; null for flow of what is drawn, without rays.</summary>
    public GameQuirks? QuirksOfRays { get; init; }

    /// <summary>The camera of a moment.</summary>
    public static RenderCamera CameraOf(Moment moment, ImageSize image)
    {
        CameraState camera = moment.Truth.Camera;
        return new RenderCamera(camera.Pose, camera.VerticalFovDegrees, camera.WindowAspect, camera.NearClip, image.Width, image.Height)
        {
            Lens = moment.Lens,
        };
    }

    /// <summary>Harvests; each frame but the first is judged with the moment before it and its own.</summary>
    public void Run(Action<FlowMaps, FlowLabel, Moment, Moment, RenderScene> judge)
    {
        var game = new SimulatedGame(
            new SimulationOptions
            {
                Seed = Seed,
                Lens = Lens,
                IsWarm = true,
                Quirks = QuirksOfRays ?? new GameQuirks(),
            }
        );
        GamePorts ports = QuirksOfRays is null ? game.Ports : game.Ports with { Surfaces = null };
        HarvestOptions options = new()
        {
            Image = Image,
            MaxFrames = Frames,
            Masks = QuirksOfRays is not null,
            Lens = new Lens(Lens.FocalScale, Lens.CentreOffsetX, Lens.CentreOffsetY, Lens.K1, Lens.K2),
            Channels = new ChannelKeys(["flow"]),
        };
        Moment? before = null;
        LabelledTown.Harvest(
            game,
            ports,
            options,
            (frame, _) =>
            {
                Moment now = game.Present;
                Assert.Equal(now.Truth.TimeSeconds, frame.Label.TimeSeconds);
                FlowLabel? label = frame.Label.Channels.Get<FlowLabel>();
                Assert.Equal(before is null, label is null);
                if (before is not null)
                {
                    Assert.Equal(frame.Label.Frame - 1, label!.From);
                    judge(frame.Part<FlowMaps>()!, label, before, now, game.World.Scene);
                }

                before = now;
            }
        );
    }
}
