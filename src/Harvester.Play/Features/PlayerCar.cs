using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>The vehicle with the camera, driven by the game's own controls, so that the player can take over at any moment.</summary>
public sealed class PlayerCar : IDrivenCar
{
    /// <summary>Below this forward speed, m/s, the game treats the brake as the reverse gear.</summary>
    private const double StandingSpeed = 0.5;

    private readonly ICarControls _controls;
    private readonly IVehicles _vehicles;
    private readonly CameraMount _mount;
    private readonly IWorld _world;
    private bool _keepsWeather;

    /// <summary>Creates the car.</summary>
    /// <param name="controls">The game's controls.</param>
    /// <param name="vehicles">Gives the player's vehicle.</param>
    /// <param name="mount">The camera, on the vehicle to drive.</param>
    /// <param name="world">Gives the vehicle's speed.</param>
    public PlayerCar(ICarControls controls, IVehicles vehicles, CameraMount mount, IWorld world)
    {
        _controls = controls;
        _vehicles = vehicles;
        _mount = mount;
        _world = world;
    }

    /// <summary>Whether the player uses a control of the vehicle, or has left it.</summary>
    public bool IsTakenByPlayer => _vehicles.OfPlayer != _mount.Vehicle || _controls.ArePlayers;

    /// <summary>The controls that move the vehicle in this frame. The handbrake counts as the brake.</summary>
    public DriveControls InForce
    {
        get
        {
            (double steering, double throttle, double brake, double handbrake) = _controls.InForce;
            return new DriveControls(-steering, throttle, Math.Max(brake, handbrake));
        }
    }

    /// <inheritdoc/>
    public void Drive(DrivingControls controls)
    {
        EgoState ego = _world.ReadEgo();
        bool stands = ego.Velocity.Dot(ego.Pose.Axes.Forward) < StandingSpeed;
        bool holds = stands && controls.Brake > controls.Throttle;
        _controls.Set(-controls.Steering, holds ? 0 : controls.Throttle, stands ? 0 : controls.Brake, holds);
    }

    /// <inheritdoc/>
    public void Reset(Vector3D position, double headingDegrees) => _controls.Place(_mount.Vehicle, position, headingDegrees);

    /// <inheritdoc/>
    public void SetEnvironment(string? weather, TimeSpan? timeOfDay)
    {
        if (weather is not null)
        {
            if (!WeatherNames.IsKnown(weather))
            {
                throw new ArgumentException($"The game has no weather {ClientText.Quoted(weather)}.", nameof(weather));
            }

            _keepsWeather = true;
            _controls.KeepWeather(weather);
        }

        if (timeOfDay is { } time)
        {
            _controls.SetTimeOfDay(time);
        }
    }

    /// <summary>Gives the weather back to the game if it was set here. The controls need no release: each holds for one frame.</summary>
    public void GiveBack()
    {
        if (_keepsWeather)
        {
            _controls.KeepWeather(null);
            _keepsWeather = false;
        }
    }
}
