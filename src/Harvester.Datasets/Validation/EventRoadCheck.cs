using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Validation;

/// <summary>Compares the measures of an event that roads decide with its participants, as it says they were at its peak.</summary>
internal static class EventRoadCheck
{
    /// <summary>Greatest time gap of a cut-in, seconds: docs/events.md.</summary>
    private const double MaxTimeGap = 2;

    /// <summary>Least speeds at a stop sign that is run, beside the road, and against the traffic, m/s: docs/events.md.</summary>
    private const double Standing = 0.5;
    private const double OffRoad = 1;
    private const double WrongWay = 2;

    /// <summary>Distances from the nearest lane that count as beside the road, metres: docs/events.md.</summary>
    private const double Shoulder = 2.5;
    private const double Beside = 30;

    /// <summary>Error of a speed whose components are rounded to 0.1 mm/s, m/s, and of other numbers rounded to four decimals.</summary>
    private const double Rounding = 0.001;

    /// <summary>What contradicts the participants.</summary>
    public static IEnumerable<string> Problems(DrivingEvent happened)
    {
        foreach (EventParticipant each in happened.Participants)
        {
            if (each.Class is { } kind && (!VehicleClasses.AreVehicles(kind) || kind == ObjectClass.Trailer))
            {
                yield return $"{JsonName.Of(kind)} cannot take part in {JsonName.Of(happened.Kind)}.";
            }
        }

        foreach (string problem in happened.Kind == EventKind.CutIn ? CutInProblems(happened) : SpeedProblems(happened))
        {
            yield return problem;
        }
    }

    private static IEnumerable<string> CutInProblems(DrivingEvent happened)
    {
        if (happened.Participants.All(each => each.Object is not null))
        {
            yield return "the ego is not among the participants of the cut-in.";
        }

        if (
            happened.Measure(EventMeasures.Gap) is not { } gap
            || happened.Measure(EventMeasures.TimeGap) is not { } time
            || happened.Measure(EventMeasures.ClosingSpeed) is null
        )
        {
            yield return "a cut-in needs gap, timeGapSeconds and closingSpeed.";
            yield break;
        }

        double speed = SpeedOf(happened.Participants[1]);
        if (gap < 0 || time < 0 || time > MaxTimeGap + Rounding || Math.Abs((time * speed) - gap) > Rounding * (1 + speed + time))
        {
            yield return FormattableString.Invariant($"timeGapSeconds is {time} s for a gap of {gap} m at {speed:F3} m/s.");
        }
    }

    private static IEnumerable<string> SpeedProblems(DrivingEvent happened)
    {
        if (happened.Measure(EventMeasures.Speed) is not { } speed)
        {
            yield return $"{JsonName.Of(happened.Kind)} needs speed.";
            yield break;
        }

        if (Math.Abs(SpeedOf(happened.Participants[0]) - speed) > Rounding)
        {
            yield return "speed is not the participant's horizontal speed.";
        }

        double? least = happened.Measure(EventMeasures.MinSpeed);
        double? from = happened.Measure(EventMeasures.FromRoad);
        string? problem = happened.Kind switch
        {
            EventKind.RedLightRun => happened.Measure(EventMeasures.Red) is < 0 ? "redSeconds is negative." : null,
            EventKind.StopSignRun => !(least >= Standing - Rounding && least <= speed + Rounding)
                ? FormattableString.Invariant($"minSpeed must be from {Standing} m/s to speed.")
                : null,
            EventKind.OffRoad => speed < OffRoad - Rounding || from is < Shoulder - Rounding or > Beside + Rounding
                ? FormattableString.Invariant($"speed must be at least {OffRoad} m/s, and fromRoad from {Shoulder} to {Beside} m.")
                : null,
            _ => speed < WrongWay - Rounding ? FormattableString.Invariant($"speed must be at least {WrongWay} m/s.") : null,
        };
        if (problem is not null)
        {
            yield return problem;
        }
    }

    private static double SpeedOf(EventParticipant participant)
    {
        Vector3D velocity = participant.Velocity;
        return Math.Sqrt((velocity.X * velocity.X) + (velocity.Y * velocity.Y));
    }
}
