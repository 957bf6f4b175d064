namespace GTA.Hosting;

/// <summary>The game that plays behind the stand-in.</summary>
internal static class GameHost
{
    private static IGameHost? _current;

    /// <summary>The game of this process.</summary>
    /// <exception cref="InvalidOperationException">There is none: the stand-in is not for use in the real game.</exception>
    public static IGameHost Current
    {
        get =>
            _current
            ?? throw new InvalidOperationException(
                "This ScriptHookVDotNet3.dll is a stand-in for tests. Delete it from the game's folders and install ScriptHookVDotNet."
            );
        set => _current = value;
    }
}
