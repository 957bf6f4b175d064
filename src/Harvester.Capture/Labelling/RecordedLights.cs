using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Labelling;

/// <summary>The traffic lights that the harvester drove when a scene was recorded.</summary>
internal sealed class RecordedLights : ILights
{
    private RecordedScene? _scene;

    public void Show(RecordedScene scene) => _scene = scene;

    public LightState? SetStateOf(int entity, long gameFrame) =>
        _scene?.Occlusions.FirstOrDefault(found => found.Handle == entity && found.SetLight is not null)?.SetLight;
}
