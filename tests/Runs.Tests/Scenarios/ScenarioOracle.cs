namespace Harvester.Runs.Tests.Scenarios;

/// <summary>
/// Judges from recorded poses and the drawn parameters alone whether what a scenario describes has happened. Distances are between origins
/// unless they are gaps.
/// </summary>
internal static class ScenarioOracle
{
    /// <summary>Half of a lane, metres, in which a vehicle counts as being in it; beyond the second it is out of it.</summary>
    private const double InLane = 1.2;
    private const double OutOfLane = 2.4;
    private const double Standing = 0.3;

    private static readonly Dictionary<string, Func<SceneTrace, IReadOnlyDictionary<string, double>, string?>> Judges = new(
        StringComparer.Ordinal
    )
    {
        ["hardBrakingLeader"] = (trace, values) => Brakes(trace.Of("leader"), values["deceleration"]),
        ["cutInLeft"] = (trace, values) => CutsIn(trace.Of("other"), -1, values["gap"]),
        ["cutInRight"] = (trace, values) => CutsIn(trace.Of("other"), 1, values["gap"]),
        ["slowVehicleOvertaken"] = (trace, values) =>
            First(trace.Of("slow"), at => at.Ahead > 0 && Math.Abs(at.Right) < InLane && Math.Abs(at.Speed - values["slow"]) < 0.5) is null
                ? "the slow vehicle is not ahead"
                : Passes(trace.Of("fast"), at => at.Right < -1.8, "fast")
                    ?? (trace.Of("fast")[^1].Ahead > trace.Of("slow")[^1].Ahead + 4 ? null : "it did not pass the slow vehicle"),
        ["pedestrianBehindParked"] = (trace, _) =>
            IsHiddenBehind(trace, "walker", "parked") ? Crosses(trace.Of("walker"), 3, 60) : "no parked vehicle stands before it",
        ["pedestrianOnCrossing"] = (trace, _) => Crosses(trace.Of("walker"), 3, 60),
        ["pedestrianOffCrossing"] = (trace, _) => Crosses(trace.Of("walker"), 3, 60),
        ["childAfterBus"] = (trace, values) =>
            trace.Of("bus")[0] is not { Speed: > 2 } || Math.Abs(trace.Of("bus")[0].Right) > InLane ? "the bus does not drive ahead"
            : trace.Of("bus")[^1] is not { Speed: < Standing, Right: > OutOfLane } ? "the bus did not stop at the roadside"
            : trace.Of("child").Max(at => at.Speed) < 0.8 * values["run"] ? "the child does not run"
            : Crosses(trace.Of("child"), 3, 60),
        ["cyclistAhead"] = (trace, values) =>
            trace.Of("cyclist").All(at => at.Ahead > 0 && Math.Abs(at.Right) < 1.8)
            && trace.Of("cyclist").Count(at => Math.Abs(at.Speed - values["ride"]) < 0.3) > trace.Moments.Count / 2
            && trace.Of("cyclist").Min(at => at.Gap) < 15
                ? null
                : "no cyclist rides slowly ahead of the ego in its lane",
        ["cyclistPassing"] = (trace, _) =>
            Passes(trace.Of("cyclist"), at => at.Right is > 1.2 and < 3.5, "the cyclist")
            ?? (trace.Of("cyclist").MinBy(at => Math.Abs(at.Ahead)).EgoSpeed < 2.5 ? null : "the ego did not wait when the cyclist passed"),
        ["doorOpening"] = (trace, _) =>
            trace.Of("parked").All(at => at.Speed < Standing && at.Right is > OutOfLane and < 5.5) && trace.Of("parked")[0].Ahead > 20
                ? null
                : "no car is parked beside the lane ahead",
        ["parkingOut"] = (trace, _) =>
            trace.Of("parked")[0] is not { Speed: < Standing, Right: > OutOfLane } ? "the car is not parked beside the lane"
            : First(trace.Of("parked"), at => Math.Abs(at.Right) < InLane && at.Ahead is > 3 and < 60 && at.Along > 2) is null
                ? "it did not come into the lane ahead of the ego"
            : null,
        ["oncomingInLane"] = (trace, _) =>
            trace.Of("oncoming")[0] is not { Right: < -OutOfLane, Along: < -2 } ? "nothing comes on the other side"
            : First(trace.Of("oncoming"), at => Math.Abs(at.Right) < InLane && at.Ahead > 10 && at.Along < -2) is not { } over
                ? "it did not come into the ego's lane"
            : First(trace.Of("oncoming"), at => at.Seconds > over.Seconds && at.Right < -1.8) is null ? "it did not return"
            : null,
        ["oncomingLeftTurn"] = (trace, _) =>
            trace.Of("other")[0] is not { Along: < -2, Ahead: > 20 } ? "nothing comes on"
            : CrossesBefore(trace.Of("other"), 1, out SeenPlace at) && at.Ahead is > 0 and < 45 ? null
            : "it did not cross the ego's line ahead of it",
        ["redLightRunLeft"] = (trace, _) => Runs(trace.Of("other"), 1),
        ["redLightRunRight"] = (trace, _) => Runs(trace.Of("other"), -1),
        ["stopSignIgnored"] = (trace, _) => Runs(trace.Of("other"), -1),
        ["merge"] = (trace, _) =>
            Math.Abs(trace.Of("other")[0].TurnDegrees - 90) > 50 ? "it does not come from the right"
            : First(
                trace.Of("other"),
                at => Math.Abs(at.Right) < InLane && Math.Abs(at.TurnDegrees) < 20 && at.Ahead is > 3 and < 60 && at.Along > 2
            )
                is null
                ? "it did not turn into the ego's lane ahead of it"
            : null,
        ["blockedWorks"] = (trace, _) =>
            Blocks(trace, "barrier") ?? Blocks(trace, "cone3") ?? (trace.Of("worker").All(at => at.Speed < Standing) ? null : "no worker"),
        ["blockedBrokenDown"] = (trace, _) => Blocks(trace, "broken"),
        ["blockedAccident"] = (trace, _) => Blocks(trace, "first") ?? Blocks(trace, "second"),
        ["emergencyFromBehind"] = (trace, _) =>
            trace.Of("police")[0].Ahead > -20
                ? "it does not come from behind"
                : Passes(trace.Of("police"), at => at.Right < -1.8, "the police car")
                    ?? (First(trace.Of("police"), at => at.Ahead > 5 && Math.Abs(at.Right) < InLane) is null ? "it did not return" : null),
        ["fourWayStop"] = (trace, _) =>
            new[] { "a", "b", "c" }.Select(id => StopsAndGoes(trace.Of(id), id)).FirstOrDefault(problem => problem is not null),
        ["animalCrossing"] = (trace, _) => Crosses(trace.Of("animal"), 3, 60),
        ["lostLoad"] = (trace, _) =>
            trace.Of("crate")[^1] is not { Speed: < Standing } || Math.Abs(trace.Of("crate")[^1].Right) > InLane
                ? "the crate does not lie in the lane"
            : trace.Of("lorry")[^1].Ahead < trace.Of("crate")[^1].Ahead + 20 ? "the lorry did not drive on"
            : Math.Abs(trace.Of("lorry")[0].Ahead - trace.Of("crate")[0].Ahead) > 10 ? "the crate was not with the lorry"
            : null,
        ["wrongWayDriver"] = (trace, _) =>
            trace.Of("other").All(at => Math.Abs(at.TurnDegrees) > 150 && Math.Abs(at.Right) < InLane && at.Ahead > 0)
            && First(trace.Of("other"), at => at.Along < -4 && at.Ahead < 60) is not null
                ? null
                : "nothing comes towards the ego in its lane",
        ["rearEndByFollower"] = (trace, _) =>
            trace.Of("leader")[^1].Speed > Standing ? "the leader did not stop"
            : RunsInto(trace.Of("follower")) ? null
            : "the follower did not run into the ego",
        ["pileUpAhead"] = (trace, _) =>
            Blocks(trace, "first", PileTouched(trace))
            ?? Blocks(trace, "second", PileTouched(trace))
            ?? (
                trace.Of("first")[^1].Ahead - trace.Of("leader")[^1].Ahead < 7 && trace.Of("leader")[^1].Speed < Standing
                    ? null
                    : "the vehicle ahead did not run into them"
            ),
        ["reversingLorry"] = (trace, values) =>
            Math.Abs(trace.Of("lorry")[0].TurnDegrees) > 20 ? "the lorry does not look ahead"
            : trace.Of("lorry").Min(at => at.Along) > -0.7 * values["back"] ? "it did not drive backwards"
            : trace.Of("lorry").All(at => at.Ahead > 0 && Math.Abs(at.Right) < InLane) ? null
            : "it did not stay in the lane ahead",
    };

    /// <summary>The kinds that can be judged.</summary>
    public static IReadOnlyCollection<string> Kinds => Judges.Keys;

    /// <summary>Why a scenario has not happened as it describes itself; null if it has.</summary>
    public static string? Problem(string kind, SceneTrace trace, IReadOnlyDictionary<string, double> values) => Judges[kind](trace, values);

    private static SeenPlace? First(SeenPlace[] places, Func<SeenPlace, bool> condition) =>
        places.Where(condition).Cast<SeenPlace?>().FirstOrDefault();

    /// <summary>Ahead in the lane, from its speed to rest, with the deceleration to 15 %.</summary>
    private static string? Brakes(SeenPlace[] leader, double deceleration)
    {
        double fast = leader[0].Speed;
        if (leader.Any(at => at.Ahead < 0 || Math.Abs(at.Right) > InLane))
        {
            return "the leader is not ahead in the lane";
        }

        SeenPlace? from = leader.Where(at => at.Speed > 0.9 * fast).Cast<SeenPlace?>().LastOrDefault();
        SeenPlace? to = First(leader, at => at.Seconds > from?.Seconds && at.Speed < 0.1 * fast);
        return to is not { } end || from is not { } begin ? "the leader did not stop"
            : Math.Abs(((begin.Speed - end.Speed) / (end.Seconds - begin.Seconds)) - deceleration) > 0.15 * deceleration
                ? "the leader braked otherwise"
            : null;
    }

    private static string? CutsIn(SeenPlace[] other, int side, double gap)
    {
        SeenPlace? before = other.Where(at => side * at.Right > 2.5).Cast<SeenPlace?>().LastOrDefault();
        SeenPlace? inside = First(other, at => at.Seconds > before?.Seconds && Math.Abs(at.Right) < 1);
        return before is null || inside is not { } cut ? "it did not come from the lane beside into the ego's"
            : cut.Ahead < 3 || cut.Ahead > gap + 8 ? FormattableString.Invariant($"it came in {cut.Ahead:0.0} m ahead")
            : null;
    }

    /// <summary>From behind the ego to ahead of it, beside it in between.</summary>
    private static string? Passes(SeenPlace[] other, Func<SeenPlace, bool> isBeside, string what)
    {
        SeenPlace? beside = First(other, at => Math.Abs(at.Ahead) < 1.5 && isBeside(at));
        return other[0].Ahead > -8 ? $"{what} does not come from behind"
            : beside is null ? $"{what} was never beside the ego"
            : First(other, at => at.Seconds > beside.Value.Seconds && at.Ahead > 4) is null ? $"{what} did not pass the ego"
            : null;
    }

    /// <summary>From the right of the ego's lane to its left, between two distances ahead of it.</summary>
    private static string? Crosses(SeenPlace[] walker, double from, double to) =>
        walker[0].Right < OutOfLane ? "it does not begin beside the lane"
        : First(walker, at => Math.Abs(at.Right) < 0.5 && at.Ahead > from && at.Ahead < to && at.Speed > 0.5) is not { } middle
            ? "it did not walk over the lane ahead of the ego"
        : First(walker, at => at.Seconds > middle.Seconds && at.Right < -InLane) is null ? "it did not come to the other side"
        : null;

    private static bool IsHiddenBehind(SceneTrace trace, string walker, string parked) =>
        trace.Of(parked)[0] is { Speed: < Standing, Right: > OutOfLane } car
        && trace.Of(walker)[0].Ahead - car.Ahead is > 1 and < 8
        && Math.Abs(trace.Of(walker)[0].Right - car.Right) < 1.6;

    /// <summary>The moment in which it is on the ego's line, on its way from one side (1 from the left) to the other.</summary>
    private static bool CrossesBefore(SeenPlace[] other, int direction, out SeenPlace at)
    {
        for (int i = 1; i < other.Length; i++)
        {
            if (direction * other[i - 1].Right < 0 && direction * other[i].Right >= 0)
            {
                at = other[i];
                return true;
            }
        }

        at = default;
        return false;
    }

    /// <summary>
    /// Straight across the ego's line, less than two seconds before or after the ego would be there, without having stopped.
    /// </summary>
    private static string? Runs(SeenPlace[] other, int direction) =>
        direction * other[0].Right > -8 ? "it does not come from the side"
        : !CrossesBefore(other, direction, out SeenPlace at) ? "it did not cross the ego's line"
        : other.Any(place => place.Seconds < at.Seconds && place.Speed < 3) ? "it stopped"
        : at.Ahead > 30 || at.Ahead < -15 ? FormattableString.Invariant($"it crossed {at.Ahead:0} m ahead of the ego")
        : null;

    /// <summary>From behind in the lane so near that it touches, faster than the ego half a second before.</summary>
    private static bool RunsInto(SeenPlace[] follower) =>
        First(follower, at => at.Ahead < 0 && Math.Abs(at.Right) < InLane && at.Gap < 0.4) is { } touch
        && follower.Any(at => at.Seconds < touch.Seconds && at.Seconds > touch.Seconds - 0.5 && at.Speed > at.EgoSpeed + 1);

    /// <summary>When the vehicle ahead is at the crashed cars, which it then pushes.</summary>
    private static double PileTouched(SceneTrace trace) =>
        trace
            .Of("leader")
            .Zip(trace.Of("first"))
            .Where(each => each.Second.Ahead - each.First.Ahead < 7)
            .Select(each => each.First.Seconds)
            .DefaultIfEmpty(double.PositiveInfinity)
            .First();

    /// <summary>Stands in the lane, until a moment whatever happens afterwards, and the ego comes near.</summary>
    private static string? Blocks(SceneTrace trace, string id, double until = double.PositiveInfinity) =>
        trace.Of(id).Where(at => at.Seconds < until).All(at => at.Speed < Standing && Math.Abs(at.Right) < 1.5)
        && trace.Of(id).Min(at => at.Gap) < 15
            ? null
            : $"'{id}' does not block the lane before the ego";

    /// <summary>Comes, stands for a moment before the ego's line, and later is on its other side or on it.</summary>
    private static string? StopsAndGoes(SeenPlace[] other, string id)
    {
        SeenPlace? stand = First(other, at => at.Seconds > 0.5 && at.Speed < Standing);
        return other[0].Speed < 2 ? $"'{id}' does not drive up"
            : stand is not { } at ? $"'{id}' did not stop"
            : First(other, later => later.Seconds > at.Seconds && later.Speed > 3) is null ? $"'{id}' did not drive on"
            : null;
    }
}
