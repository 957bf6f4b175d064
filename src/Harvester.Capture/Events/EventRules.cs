namespace Harvester.Capture.Events;

/// <summary>The thresholds of events, with their sources. docs/events.md defines what they apply to.</summary>
public static class EventRules
{
    /// <summary>
    /// Footprints that are at most so far apart touch, metres: models' boxes are known to the centimetre, and bodies that a game pushes
    /// apart stay at a small distance.
    /// </summary>
    public const double ContactMetres = 0.02;

    /// <summary>Time to collision of a near miss, seconds (van der Horst 1990; the default of SSAM, FHWA-HRT-08-051).</summary>
    public const double TimeToCollisionSeconds = 1.5;

    /// <summary>
    /// Post-encroachment time of a near miss, seconds (Allen, Shin and Cooper 1978 define it; conflicts are serious below 1.5 s, van der
    /// Horst 1990).
    /// </summary>
    public const double PostEncroachmentSeconds = 1.5;

    /// <summary>Two who approach each other more slowly are no near miss but a queue, m/s.</summary>
    public const double MinRelativeSpeed = 2;

    /// <summary>Angle at which ways cross, degrees: below it, SSAM speaks of rear-end conflicts.</summary>
    public const double CrossingDegrees = 30;

    /// <summary>The second to enter a place moves at least so fast, m/s: somebody on foot does.</summary>
    public const double MinCrossingSpeed = 1;

    /// <summary>Deceleration of hard braking, m/s²: 0.45 g (Simons-Morton et al. 2011).</summary>
    public const double HardBraking = 0.45 * 9.80665;

    /// <summary>Time over which the deceleration of hard braking is the mean, seconds.</summary>
    public const double BrakingWindowSeconds = 0.5;

    /// <summary>Time from the first contact in which velocities change by the collision, seconds: crash pulses last 0.1 to 0.2 s.</summary>
    public const double CrashPulseSeconds = 0.25;

    /// <summary>Time for which the condition of an event does not hold before the event is known to be over, seconds.</summary>
    public const double HoldSeconds = 1;

    /// <summary>Time between the two headings whose difference gives the turning rate, seconds; longer where readings are rarer.</summary>
    public const double YawWindowSeconds = 0.1;

    /// <summary>
    /// A road user that has moved by more than this beyond what its speed allows was placed elsewhere, metres.
    /// </summary>
    public const double JumpMetres = 1;

    /// <summary>
    /// Time gap of a cut-in, seconds: the least that most authorities recommend (Vogel 2003).
    /// </summary>
    public const double CutInSeconds = 2;

    /// <summary>Below this speed a vehicle is queueing rather than being cut off, m/s.</summary>
    public const double MinCutInSpeed = 2;

    /// <summary>
    /// Before a stop line, a vehicle that was slower than this stood, m/s: an observer does not see wheels turn more slowly.
    /// </summary>
    public const double StandingSpeed = 0.5;

    /// <summary>Distance before a stop line within which a vehicle stops for it, metres: one car and a half.</summary>
    public const double StopMetres = 8;

    /// <summary>How far before a stop line a vehicle must have been seen, so that it is known that it did not stop, metres.</summary>
    public const double SeenMetres = 4;

    /// <summary>
    /// Distance beside the lanes up to which a vehicle is on the road, metres: the widest usual shoulder and parking lane, 8 feet, AASHTO.
    /// </summary>
    public const double ShoulderMetres = 2.5;

    /// <summary>Distance up to which the nearest lane is looked for beside the road, metres.</summary>
    public const double BesideMetres = 30;

    /// <summary>Beside the road, one that is slower than this is parked or manoeuvres, m/s.</summary>
    public const double MinOffRoadSpeed = 1;

    /// <summary>Against the traffic, one that is slower than this manoeuvres, m/s.</summary>
    public const double MinWrongWaySpeed = 2;

    /// <summary>Angle from a lane's direction beyond which a vehicle drives against it, degrees.</summary>
    public const double WrongWayDegrees = 120;

    /// <summary>Time for which a vehicle drives against the traffic before it is an event, seconds: less is a swerve.</summary>
    public const double WrongWaySeconds = 1;

    /// <summary>Greatest angle between a vehicle and the lane that it drives on, degrees.</summary>
    public const double LaneDegrees = 60;

    /// <summary>Roads and lines farther above or below are on another level, metres.</summary>
    public const double LevelMetres = 3;
}
