using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// What a driver shows to others: brake lights, indicators before and in turns at junctions, and hazard lights after an impact.
/// </summary>
internal sealed class VehicleSignals
{
    /// <summary>Weaker deceleration comes from the engine, without the pedal, m/s².</summary>
    public const double BrakingFrom = 0.5;

    /// <summary>Frequency of indicators, Hz.</summary>
    public const double BlinkHertz = 1.5;

    /// <summary>Ways through junctions that turn by less are straight on, radians.</summary>
    public const double TurnFrom = 0.5;

    /// <summary>Indicators are set this far before a turn, metres.</summary>
    public const double AnnouncedMetres = 30;

    /// <summary>The brake lights stay on for a moment after the pedal was used, so that they do not flicker, seconds.</summary>
    private const double Afterglow = 0.25;

    /// <summary>The indicators of a staged vehicle, which has no route that sets them.</summary>
    public StageIndicators Ordered { get; set; }

    private double _brakedSeconds = Afterglow;
    private double _speedBefore;

    /// <summary>Notes the speed after a tick.</summary>
    public void Tick(double speed, double seconds)
    {
        bool brakes = speed == 0 || (_speedBefore - speed) / seconds > BrakingFrom;
        _brakedSeconds = brakes ? 0 : _brakedSeconds + seconds;
        _speedBefore = speed;
    }

    /// <summary>The lamps that shine at a time.</summary>
    public VehicleLights At(Vehicle vehicle, double timeSeconds, bool isDark)
    {
        double turn = vehicle.Staged is null ? TurnOf(vehicle) : 0;
        bool isWarning = vehicle.Wreck is not null;
        bool isLeft = turn > TurnFrom || Ordered is StageIndicators.Left or StageIndicators.Hazard || isWarning;
        bool isRight = turn < -TurnFrom || Ordered is StageIndicators.Right or StageIndicators.Hazard || isWarning;
        bool isBlinkOn = ((timeSeconds * BlinkHertz) + (vehicle.Handle * 0.618)) % 1 < 0.5;
        return new VehicleLights(_brakedSeconds < Afterglow, isBlinkOn && isLeft, isBlinkOn && isRight, isDark);
    }

    /// <summary>The angle of the turn on which it is or which is next, radians, positive to the left; 0 without one.</summary>
    private static double TurnOf(Vehicle vehicle)
    {
        LanePath way = vehicle.Path;
        if (way.Junction is null && vehicle.Route.Count > 1 && way.Length - vehicle.Distance < AnnouncedMetres)
        {
            way = vehicle.Route[1];
        }

        return way.Junction is null ? 0 : Horizontal.Turn(way.Line.TangentAt(0), way.Line.TangentAt(way.Length));
    }
}
