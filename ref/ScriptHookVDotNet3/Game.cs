using GTA.Hosting;

namespace GTA;

/// <summary>The game itself.</summary>
public static class Game
{
    /// <summary>The game's build.</summary>
    public static GameVersion Version => (GameVersion)GameHost.Current.GameVersion;
}
