namespace Harvester.Play.Features;

/// <summary>What the player can do about failures of the game that it reports without a remedy.</summary>
internal static class FailureAdvice
{
    private const string FullPool = "pool is full";

    /// <summary>The message, with a remedy where there is one.</summary>
    public static string AddTo(string message) =>
        message.IndexOf(FullPool, StringComparison.OrdinalIgnoreCase) < 0
            ? message
            : $"{message.TrimEnd('.')}. Restart the game, and remove mods that hold many vehicles, people or props.";
}
