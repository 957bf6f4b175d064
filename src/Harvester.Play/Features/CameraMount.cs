using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Settings;
using Harvester.Sessions.Rigs;

namespace Harvester.Play.Features;

/// <summary>
/// The camera on the hood. The game itself attaches it with the vehicle's whole matrix, so there is no delay between the two; setting
/// position and rotation on every tick, as the thesis did, lags a frame behind.
/// </summary>
public sealed class CameraMount : ILastingFeature, IMount, IMountedCamera, IRigCamera
{
    private readonly PlayerSettings _settings;
    private readonly PlayerMessages _messages;
    private readonly ICameras _cameras;
    private readonly IVehicles _vehicles;
    private int _camera;
    private Pose _place;
    private double _verticalFovDegrees;

    /// <summary>Creates the feature; the camera is not mounted.</summary>
    /// <param name="settings">Position of the camera on its vehicle.</param>
    /// <param name="messages">Reports the result.</param>
    /// <param name="cameras">The game's cameras.</param>
    /// <param name="vehicles">The game's vehicles.</param>
    public CameraMount(PlayerSettings settings, PlayerMessages messages, ICameras cameras, IVehicles vehicles)
    {
        _settings = settings;
        _messages = messages;
        _cameras = cameras;
        _vehicles = vehicles;
        _place = UsualPlace;
        _verticalFovDegrees = settings.VerticalFovDegrees;
    }

    /// <inheritdoc/>
    public string Name => "The camera";

    /// <inheritdoc/>
    public bool IsMounted => Vehicle != 0;

    /// <inheritdoc/>
    public bool IsOn => IsMounted;

    /// <inheritdoc/>
    public bool IsBusy => false;

    /// <summary>The vehicle that carries the camera; 0 if it is not mounted.</summary>
    public int Vehicle { get; private set; }

    private Pose UsualPlace => new(_settings.CameraOffset, Axes.Identity);

    /// <summary>Vertical field of view from the next mounting on, degrees; null for that of the settings.</summary>
    public double? VerticalFovDegrees { get; set; }

    /// <summary>Mounts the rendering camera on the vehicle of the player.</summary>
    public void Mount()
    {
        if (_cameras.AttachingProblem is { } problem)
        {
            _messages.Tell(problem);
            return;
        }

        int vehicle = _vehicles.OfPlayer;
        if (vehicle == 0)
        {
            _messages.Tell("Enter a vehicle first: the camera is mounted on the one you sit in.");
            return;
        }

        Stop();
        double verticalFovDegrees = VerticalFovDegrees ?? _settings.VerticalFovDegrees;
        int camera = _cameras.Make(new Pose(Vector3D.Zero, Axes.Identity), verticalFovDegrees);
        if (camera == 0)
        {
            _messages.Tell("The game did not create a camera. Other mods may use too many.");
            return;
        }

        _camera = camera;
        try
        {
            (_place, _verticalFovDegrees) = (UsualPlace, verticalFovDegrees);
            _cameras.Attach(camera, vehicle, _place);
            _cameras.Show(camera);
            Vehicle = vehicle;
        }
        finally
        {
            // Callers that need a mounted camera must not get one that is not shown.
            if (Vehicle == 0)
            {
                Stop();
            }
        }

        _messages.Tell("The camera is mounted.");
    }

    /// <inheritdoc/>
    public void Shift(Vector3D offset)
    {
        if (IsMounted)
        {
            _cameras.Attach(_camera, Vehicle, _place with { Position = _place.Position + offset });
        }
    }

    /// <inheritdoc/>
    public void Show(RigCamera camera, Pose mount)
    {
        if (camera is not null)
        {
            MoveTo(mount, camera.VerticalFovDegrees);
        }
    }

    /// <inheritdoc/>
    public void MoveBack() => MoveTo(UsualPlace, _settings.VerticalFovDegrees);

    /// <inheritdoc/>
    public void Tick()
    {
        if (Vehicle == 0)
        {
            Stop();
            return;
        }

        if (!_vehicles.Exists(Vehicle))
        {
            Stop();
            _messages.Tell("The vehicle with the camera is gone. The view is yours again.");
        }
        else if (_vehicles.OfPlayer != Vehicle)
        {
            Stop();
            _messages.Tell("You left the vehicle with the camera. The view is yours again.");
        }
    }

    /// <summary>Restores the game's own view.</summary>
    public void Stop()
    {
        Vehicle = 0;
        if (_camera != 0)
        {
            // The handle is kept until the camera is removed: if the game refuses, the next tick tries again.
            _cameras.Remove(_camera);
            _camera = 0;
        }
    }

    /// <inheritdoc/>
    public void Finish() => Stop();

    private void MoveTo(Pose place, double verticalFovDegrees)
    {
        if (!IsMounted)
        {
            return;
        }

        if (_place != place)
        {
            _cameras.Attach(_camera, Vehicle, place);
            _place = place;
        }

        if (!_verticalFovDegrees.Equals(verticalFovDegrees))
        {
            _cameras.Zoom(_camera, verticalFovDegrees);
            _verticalFovDegrees = verticalFovDegrees;
        }
    }
}
