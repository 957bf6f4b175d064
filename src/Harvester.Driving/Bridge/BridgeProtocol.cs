namespace Harvester.Driving.Bridge;

/// <summary>The version of the bridge's protocol, which each side names in its hello; docs/bridge.md has the protocol.</summary>
public static class BridgeProtocol
{
    /// <summary>Version of this program. A client of another version is refused.</summary>
    public const int Version = 1;

    /// <summary>Type of the message by which a client begins, and of the game's answer to it.</summary>
    public const string HelloType = "hello";

    /// <summary>Name of the file that holds the game's hello in a shared folder.</summary>
    public const string HelloFile = "bridge.json";

    /// <summary>The answer to a client that asks for a restart of a game that has none.</summary>
    internal const string NoRestart = "this game cannot be restarted; the simulated game can, if served with --lockstep.";

    /// <summary>The game's hello.</summary>
    public static string HelloOfGame { get; } = FormattableString.Invariant($"{{\"type\":\"{HelloType}\",\"version\":{Version}}}");

    /// <summary>Compares the version that the game's hello names with that of this program, which is its client.</summary>
    /// <param name="hello">The header.</param>
    /// <returns>What is wrong, naming both versions; null if nothing is.</returns>
    /// <exception cref="BridgeException">The header is no hello.</exception>
    public static string? ProblemOfGame(string hello)
    {
        HeaderFields fields = HeaderFields.Parse(hello);
        if (fields.Text("type") != HelloType)
        {
            throw new BridgeException("the first message of the game must be a hello.");
        }

        double version = fields.Number("version");
        return version == Version
            ? null
            : FormattableString.Invariant($"the game speaks version {version} of the bridge, this program version {Version}.");
    }

    /// <summary>Checks the version that a client's hello names.</summary>
    /// <exception cref="BridgeException">It is another one, or missing.</exception>
    internal static void CheckClient(HeaderFields hello)
    {
        if (!hello.Has("version"))
        {
            throw new BridgeException(
                FormattableString.Invariant($"the hello names no version; the game speaks version {Version} of the bridge.")
            );
        }

        double version = hello.Number("version");
        if (version != Version)
        {
            throw new BridgeException(
                FormattableString.Invariant($"the client speaks version {version} of the bridge, the game version {Version}.")
            );
        }
    }
}
