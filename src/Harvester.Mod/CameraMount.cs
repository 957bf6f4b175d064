using Harvester.Capture.Playing;
using Harvester.Capture.Settings;

namespace Harvester.Mod;

/// <summary>
/// The camera on the hood. The game itself attaches it with the vehicle's whole matrix, so that no tick's delay comes between the
/// two; setting position and rotation on every tick, as the thesis did, lags a frame behind.
/// </summary>
internal sealed class CameraMount : IFeature, IMount
{
    private readonly PlayerSettings _settings;
    private readonly PlayerMessages _messages;
    private int _camera;

    public CameraMount(PlayerSettings settings, PlayerMessages messages)
    {
        _settings = settings;
        _messages = messages;
    }

    /// <inheritdoc/>
    public string Name => "The camera";

    /// <inheritdoc/>
    public bool IsMounted => Vehicle != 0;

    /// <summary>The vehicle that carries the camera; 0 when it is not mounted.</summary>
    public int Vehicle { get; private set; }

    /// <summary>Mounts the rendering camera on the vehicle that the player sits in.</summary>
    public void Mount()
    {
        if (GameBuild.MountProblem is { } problem)
        {
            _messages.Tell(problem);
            return;
        }

        int vehicle = Natives.VehicleOf(Natives.PlayerPed());
        if (vehicle == 0)
        {
            _messages.Tell("Enter a vehicle first: the camera is mounted on the one you sit in.");
            return;
        }

        Stop();
        int camera = Natives.CreateCamera((float)_settings.VerticalFovDegrees);
        if (!Natives.CameraExists(camera))
        {
            _messages.Tell("The game did not make a camera. Too many may be in use by other mods.");
            return;
        }

        _camera = camera;
        Vehicle = vehicle;
        Natives.AttachRigidly(camera, vehicle, _settings.CameraOffset);
        Natives.SetCameraActive(camera, true);
        Natives.RenderScriptedCameras(true);
        _messages.Tell("The camera is mounted.");
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (Vehicle != 0 && !Natives.EntityExists(Vehicle))
        {
            Stop();
            _messages.Tell("The vehicle with the camera is gone. The view is yours again.");
        }
    }

    /// <summary>Gives the view back to the game. Cameras of other mods are left alone.</summary>
    public void Stop()
    {
        int camera = _camera;
        _camera = 0;
        Vehicle = 0;
        if (camera == 0 || !Natives.CameraExists(camera))
        {
            return;
        }

        if (Natives.RenderingCamera() == camera)
        {
            Natives.RenderScriptedCameras(false);
        }

        Natives.SetCameraActive(camera, false);
        Natives.DestroyCamera(camera);
    }
}
