using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>What the head of a traffic light shows.</summary>
/// <param name="State">The lamp that burns.</param>
/// <param name="Method">How it is known.</param>
/// <param name="LitFraction">Share of the head's box in the picture whose pixels shine in the lamp's colour, 0 to 1; null unless it was
/// observed.</param>
public sealed record LightLabel(LightState State, LightMethod Method, double? LitFraction)
{
    /// <summary>Nothing is known of it.</summary>
    public static LightLabel Unknown { get; } = new(LightState.Unknown, LightMethod.Unknown, null);
}
