using Harvester.Geometry;
using Harvester.Sessions.Events;

namespace Harvester.Datasets.Validation;

/// <summary>Computes the measures of an event again, from its participants as the event says they were at its peak.</summary>
internal static class EventPeakCheck
{
    /// <summary>Footprints at most so far apart touch, metres: docs/events.md.</summary>
    private const double Contact = 0.02;

    /// <summary>Mean deceleration over the window from which braking is hard, m/s², and the window, seconds: docs/events.md.</summary>
    private const double HardBraking = 0.45 * 9.80665;
    private const double Window = 0.5;

    /// <summary>Greatest time to collision and post-encroachment time of a near miss, seconds: docs/events.md.</summary>
    private const double MaxSeconds = 1.5;

    /// <summary>
    /// Error of a distance between two footprints whose numbers are rounded to 0.1 mm and 9 decimals, and which move for up to 1.5 s with
    /// velocities and turning rates rounded to 0.1 mm/s and 1e-6 rad/s, metres; and the error of a time to collision, at most a millisecond
    /// at speeds up to 10 m/s against each other.
    /// </summary>
    private const double DistanceError = 0.02;

    /// <summary>
    /// Error of a speed whose components are rounded to 0.1 mm/s, and of a quotient of two over the window, m/s and m/s².
    /// </summary>
    private const double SpeedError = 0.001;

    private const int Corners = 4;

    /// <summary>What contradicts the participants.</summary>
    public static IEnumerable<string> Problems(DrivingEvent happened) =>
        happened.Kind switch
        {
            EventKind.Collision => CollisionProblems(happened),
            EventKind.NearMiss => NearMissProblems(happened),
            EventKind.HardBraking => BrakingProblems(happened),
            _ => EventRoadCheck.Problems(happened),
        };

    private static IEnumerable<string> CollisionProblems(DrivingEvent happened)
    {
        double apart = Distance(happened.Participants[0], happened.Participants[1], 0);
        if (apart > Contact + DistanceError)
        {
            yield return FormattableString.Invariant($"the participants of the collision are {apart:F3} m apart at its peak.");
        }

        if (happened.Contact is not { } contact)
        {
            yield return "a collision needs contact.";
        }
        else if (
            !(contact.RelativeSpeed >= 0)
            || !(contact.FirstSpeedChange >= 0)
            || !(contact.SecondSpeedChange >= 0)
            || !(contact.ImpulseMin >= 0 && contact.ImpulseMin <= contact.Impulse && contact.Impulse <= contact.ImpulseMax)
        )
        {
            yield return "contact has a negative number, or an impulse outside its limits.";
        }
        else if (Beyond(happened.Participants[0], contact) > DistanceError || Beyond(happened.Participants[1], contact) > DistanceError)
        {
            yield return "contact.position is not on both participants.";
        }
    }

    private static IEnumerable<string> NearMissProblems(DrivingEvent happened)
    {
        double? time = happened.Measure(EventMeasures.TimeToCollision);
        double? encroachment = happened.Measure(EventMeasures.PostEncroachment);
        if (time is null && encroachment is null)
        {
            yield return "a near miss needs a time to collision or a post-encroachment time.";
        }

        if (time is < 0 or > MaxSeconds || encroachment is < 0 or > MaxSeconds)
        {
            yield return FormattableString.Invariant($"a near miss has times from 0 to {MaxSeconds} s.");
        }
        else if (time is { } least && (encroachment is null || least < encroachment))
        {
            // The peak is the moment of the least time to collision.
            double apart = Distance(happened.Participants[0], happened.Participants[1], least);
            if (apart > Contact + DistanceError)
            {
                yield return FormattableString.Invariant(
                    $"the participants are {apart:F3} m apart {least:F3} s after the peak, when they should touch."
                );
            }
        }
    }

    private static IEnumerable<string> BrakingProblems(DrivingEvent happened)
    {
        if (
            happened.Measure(EventMeasures.Deceleration) is not { } deceleration
            || happened.Measure(EventMeasures.SpeedBefore) is not { } before
            || happened.Measure(EventMeasures.SpeedAfter) is not { } after
        )
        {
            yield return "hard braking needs deceleration, speedBefore and speedAfter.";
            yield break;
        }

        if (deceleration < HardBraking - SpeedError || Math.Abs(deceleration - ((before - after) / Window)) > SpeedError)
        {
            yield return FormattableString.Invariant($"deceleration is {deceleration} m/s² from {before} to {after} m/s in {Window} s.");
        }

        Vector3D velocity = happened.Participants[0].Velocity;
        if (Math.Abs(Math.Sqrt((velocity.X * velocity.X) + (velocity.Y * velocity.Y)) - after) > SpeedError)
        {
            yield return "speedAfter is not the participant's horizontal speed.";
        }
    }

    /// <summary>
    /// Distance of two footprints after a time, metres; 0 if they overlap. As for polygons that are apart: the least distance of their
    /// edges.
    /// </summary>
    private static double Distance(EventParticipant a, EventParticipant b, double seconds)
    {
        Vector2D[] first = CornersAfter(a, seconds);
        Vector2D[] second = CornersAfter(b, seconds);
        if (Depth(first, second) >= 0 && Depth(second, first) >= 0)
        {
            return 0;
        }

        double least = double.PositiveInfinity;
        for (int i = 0; i < Corners; i++)
        {
            for (int j = 0; j < Corners; j++)
            {
                least = Math.Min(least, ToEdge(first[i], second[j], second[(j + 1) % Corners]));
                least = Math.Min(least, ToEdge(second[i], first[j], first[(j + 1) % Corners]));
            }
        }

        return least;
    }

    /// <summary>How far a place of contact lies outside a footprint, metres; 0 or less inside.</summary>
    private static double Beyond(EventParticipant participant, EventContact contact)
    {
        Vector2D[] corners = CornersAfter(participant, 0);
        var place = new Vector2D(contact.Position.X, contact.Position.Y);
        return Enumerable.Range(0, Corners).Max(i => Outside(corners[i], corners[(i + 1) % Corners], place)) - Contact;
    }

    /// <summary>
    /// By how much the projections of two polygons on the normals of the first overlap at least; negative if one parts them.
    /// </summary>
    private static double Depth(Vector2D[] polygon, Vector2D[] other) =>
        Enumerable.Range(0, Corners).Min(i => -other.Min(point => Outside(polygon[i], polygon[(i + 1) % Corners], point)));

    /// <summary>Distance of a point to the right of an edge of a polygon that turns to the left, metres; negative inside.</summary>
    private static double Outside(Vector2D from, Vector2D to, Vector2D point) => -(to - from).Cross(point - from) / (to - from).Length;

    private static double ToEdge(Vector2D point, Vector2D from, Vector2D to)
    {
        Vector2D edge = to - from;
        double along = Math.Clamp((point - from).Dot(edge) / edge.Dot(edge), 0, 1);
        return (point - from - (edge * along)).Length;
    }

    /// <summary>The corners of a footprint after a time at constant speed and turning rate, counter-clockwise.</summary>
    private static Vector2D[] CornersAfter(EventParticipant body, double seconds)
    {
        double turn = body.YawRate * seconds;
        (double sin, double cos) = Math.SinCos(turn);

        // The chord of the arc: its length is that of the arc times sin(turn / 2) / (turn / 2), its direction is turned by half the turn.
        double half = turn / 2;
        double shortening = Math.Abs(half) < 1e-6 ? 1 : Math.Sin(half) / half;
        (double sinHalf, double cosHalf) = Math.SinCos(half);
        var chord = new Vector2D(
            ((body.Velocity.X * cosHalf) - (body.Velocity.Y * sinHalf)) * shortening * seconds,
            ((body.Velocity.X * sinHalf) + (body.Velocity.Y * cosHalf)) * shortening * seconds
        );
        Vector3D middle = body.Pose.Axes.ToWorld((body.ModelMin + body.ModelMax) * 0.5);
        double heading = Math.Atan2(body.Pose.Axes.Forward.Y, body.Pose.Axes.Forward.X) + turn;
        (double sinHeading, double cosHeading) = Math.SinCos(heading);
        Vector3D half3 = (body.ModelMax - body.ModelMin) * 0.5;
        var centre = new Vector2D(
            body.Pose.Position.X + chord.X + (middle.X * cos) - (middle.Y * sin),
            body.Pose.Position.Y + chord.Y + (middle.X * sin) + (middle.Y * cos)
        );
        var ahead = new Vector2D(cosHeading * half3.Y, sinHeading * half3.Y);
        var left = new Vector2D(-sinHeading * half3.X, cosHeading * half3.X);
        return [centre + ahead + left, centre - ahead + left, centre - ahead - left, centre + ahead - left];
    }
}
