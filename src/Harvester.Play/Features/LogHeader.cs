using Harvester.Play.Screen;

namespace Harvester.Play.Features;

/// <summary>The first lines of a run in the log: what a reader needs to know about the game and the computer.</summary>
public static class LogHeader
{
    /// <summary>Precedes the description of the window.</summary>
    public const string Window = "Window: ";

    /// <summary>Precedes the settings that differ from the defaults.</summary>
    public const string Changes = "Changed settings: ";

    /// <summary>The lines.</summary>
    /// <param name="versions">The mod, the API and the game with their versions.</param>
    /// <param name="window">The game's window; null if it is unknown.</param>
    /// <param name="changes">The settings that differ from their defaults.</param>
    public static IEnumerable<string> Lines(string versions, IGameWindow? window, IReadOnlyList<string> changes)
    {
        yield return $"{versions}.";
        yield return $"System: {Environment.OSVersion.VersionString}, runtime {Environment.Version}.";
        yield return $"{Window}{DescriptionOf(window)}.";
        yield return $"{Changes}{(changes is { Count: > 0 } ? string.Join("; ", changes) : "none")}.";
    }

    private static string DescriptionOf(IGameWindow? window)
    {
        try
        {
            return window?.Describe() ?? "unknown";
        }
        catch (Exception exception) when (exception is DllNotFoundException or EntryPointNotFoundException)
        {
            // Wine and old versions of Windows lack some functions.
            return $"unknown ({exception.Message})";
        }
    }
}
