using Harvester.Sessions.Events;

namespace Harvester.Simulation.Tests.Events;

/// <summary>An event as the oracle finds it. The ego has the handle 0; the second handle is -1 for an event of one.</summary>
internal sealed record TrueEvent(EventKind Kind, int First, int Second, double Begin, double End) : IComparable<TrueEvent>
{
    public int CompareTo(TrueEvent? other) =>
        other is null ? 1 : (Begin, First, Second).CompareTo((other.Begin, other.First, other.Second));
}
