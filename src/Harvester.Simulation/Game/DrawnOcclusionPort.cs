using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>Draws the whole scene, and each entity alone, and compares the pixels. The colours of these pictures are not used.</summary>
internal sealed class DrawnOcclusionPort(SimulatedGame game) : IDrawnOcclusion
{
    private static readonly RenderScene Empty = new([]);

    private readonly Renderer _renderer = new();
    private RenderTarget? _whole;
    private RenderTarget? _alone;
    private RenderScene? _world;
    private ILookup<int, MeshInstance>? _fixed;

    public IReadOnlyDictionary<int, double> HiddenFractions(IReadOnlyCollection<int> handles, ImageSize image)
    {
        Moment moment = game.Present;
        RenderScene world = game.World.Scene;
        if (_fixed is null || _world != world)
        {
            (_world, _fixed) = (world, world.Static.Instances.ToArray().ToLookup(instance => instance.Handle));
        }

        if (_whole is null || _whole.Width != image.Width || _whole.Height != image.Height)
        {
            (_whole, _alone) = (new RenderTarget(image.Width, image.Height), new RenderTarget(image.Width, image.Height));
        }

        CameraState camera = moment.Truth.Camera;
        RenderCamera eye = new(camera.Pose, camera.VerticalFovDegrees, camera.WindowAspect, camera.NearClip, image.Width, image.Height)
        {
            Lens = game.Lens,
        };
        _renderer.Render(moment.SceneIn(world), eye, _whole);
        ILookup<int, MeshInstance> moving = moment.Moving.ToLookup(instance => instance.Handle);
        Dictionary<int, double> fractions = [];
        foreach (int handle in handles)
        {
            _renderer.Render(new RenderScene(Empty, _fixed[handle].Concat(moving[handle])), eye, _alone!);
            int drawn = 0,
                hidden = 0;
            for (int pixel = 0; pixel < _alone!.Handles.Length; pixel++)
            {
                if (_alone.Handles[pixel] == handle)
                {
                    drawn++;
                    hidden += _whole.Handles[pixel] == handle ? 0 : 1;
                }
            }

            if (drawn > 0)
            {
                fractions[handle] = (double)hidden / drawn;
            }
        }

        return fractions;
    }
}
