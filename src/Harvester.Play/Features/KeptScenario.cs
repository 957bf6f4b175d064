namespace Harvester.Play.Features;

/// <summary>What a session keeps of the scenario that was staged in it.</summary>
/// <param name="Settings">Further settings of the game.</param>
/// <param name="Text">Gives the text of scenario.json when the session ends; called on another thread.</param>
public sealed record KeptScenario(IReadOnlyList<KeyValuePair<string, string>> Settings, Func<string> Text);
