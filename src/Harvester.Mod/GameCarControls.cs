using GTA.Native;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>The game's controls, by its natives. Numbers of controls are the game's.</summary>
internal sealed class GameCarControls : ICarControls
{
    private const int Player = 0;
    private const int Steer = 59;
    private const int Accelerate = 71;
    private const int Brake = 72;
    private const int Handbrake = 76;

    /// <summary>Number of ticks after which a value set here no longer applies: one, and one more for a game that is late.</summary>
    private const int TicksOfASetControl = 2;

    // Other controls on the same keys, buttons and sticks, since values set here are read back as if the player held them: steer left and
    // right, leave the vehicle, and throttle up and down of aircraft.
    private static readonly int[] PlayersControls = [63, 64, 75, 87, 88];

    // No other control shares the handbrake's button: it is the player's if it was not set here recently.
    private int _ticksWithoutHandbrake = TicksOfASetControl;

    /// <inheritdoc/>
    public bool ArePlayers => Array.Exists(PlayersControls, IsHeld) || (_ticksWithoutHandbrake >= TicksOfASetControl && IsHeld(Handbrake));

    /// <inheritdoc/>
    public (double Steering, double Throttle, double Brake, double Handbrake) InForce =>
        (ValueOf(Steer), ValueOf(Accelerate), ValueOf(Brake), ValueOf(Handbrake));

    /// <inheritdoc/>
    public void Set(double steering, double throttle, double brake, bool handbrake)
    {
        Set(Steer, steering);
        Set(Accelerate, throttle);
        Set(Brake, brake);
        _ticksWithoutHandbrake = handbrake ? 0 : Math.Min(_ticksWithoutHandbrake + 1, TicksOfASetControl);
        if (handbrake)
        {
            Set(Handbrake, 1);
        }
    }

    /// <inheritdoc/>
    public void Place(int vehicle, Vector3D position, double headingDegrees)
    {
        Natives.Call(
            Hash.SET_ENTITY_COORDS_NO_OFFSET,
            vehicle,
            (float)position.X,
            (float)position.Y,
            (float)position.Z,
            false,
            false,
            false
        );
        Natives.Call(Hash.SET_ENTITY_HEADING, vehicle, (float)headingDegrees);
        Natives.Call(Hash.SET_ENTITY_VELOCITY, vehicle, 0f, 0f, 0f);
        Natives.PlaceOnGround(vehicle);
    }

    /// <inheritdoc/>
    public void KeepWeather(string? weather)
    {
        if (weather is null)
        {
            Natives.Call(Hash.CLEAR_WEATHER_TYPE_PERSIST);
        }
        else
        {
            Natives.Call(Hash.SET_WEATHER_TYPE_NOW_PERSIST, weather.ToUpperInvariant());
        }
    }

    /// <inheritdoc/>
    public void SetTimeOfDay(TimeSpan timeOfDay) =>
        Natives.Call(Hash.SET_CLOCK_TIME, timeOfDay.Hours, timeOfDay.Minutes, timeOfDay.Seconds);

    private static double ValueOf(int control) => Natives.Call<float>(Hash.GET_CONTROL_NORMAL, Player, control);

    private static bool IsHeld(int control) => Natives.Call<bool>(Hash.IS_CONTROL_PRESSED, Player, control);

    private static void Set(int control, double value) => Natives.Call(Hash.SET_CONTROL_VALUE_NEXT_FRAME, Player, control, (float)value);
}
