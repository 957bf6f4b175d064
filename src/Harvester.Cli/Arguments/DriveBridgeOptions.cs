using System.CommandLine;
using System.Net;
using Harvester.Runs.Driving;
using Harvester.Runs.Faults;

namespace Harvester.Cli.Arguments;

/// <summary>The options of a drive over a bridge: which bridge, and which side of it this process runs.</summary>
internal sealed class DriveBridgeOptions
{
    private Option<string> Bridge { get; } =
        Word("--bridge", "B", "Connection between game and controller: direct, folder or socket", "direct");
    private Option<string> Role { get; } = Word("--role", "R", "Side of the bridge that this process runs: game, client or both", "both");
    private Option<DirectoryInfo?> Folder { get; } =
        new("--folder") { Description = "Shared folder of a folder bridge [default: bridge in the folder of --out]", HelpName = "DIR" };
    private Option<string?> At { get; } =
        new("--at")
        {
            Description = "Address of a socket bridge: the game listens there, the client connects to it [default: 127.0.0.1:4567]",
            HelpName = "ADDRESS:PORT",
        };

    private Option<string?> Token { get; } =
        new("--token") { Description = "Secret that a client on another machine must send", HelpName = "WORD" };

    private Option<double> Patience { get; } = Patient();

    public IEnumerable<Option> All => [Bridge, Role, Folder, At, Token, Patience];

    /// <summary>The plan that the options describe.</summary>
    /// <exception cref="UsageException">The options contradict each other.</exception>
    /// <exception cref="Datasets.Files.OccupiedFolderException">The shared folder has files that are not a bridge's.</exception>
    public BridgePlan Parse(ParseResult parsed, string? outFolder)
    {
        BridgeName kind = parsed.GetRequiredValue(Bridge) switch
        {
            "direct" => BridgeName.Direct,
            "folder" => BridgeName.Folder,
            "socket" => BridgeName.Socket,
            string other => throw new UsageException($"--bridge takes direct, folder or socket, not '{other}'."),
        };
        DriveRole role = parsed.GetRequiredValue(Role) switch
        {
            "both" => DriveRole.Both,
            "game" => DriveRole.Game,
            "client" or "peer" => DriveRole.Client,
            string other => throw new UsageException($"--role takes both, game or client, not '{other}'."),
        };
        if (kind == BridgeName.Direct && role != DriveRole.Both)
        {
            throw new UsageException("--role game and --role client need --bridge folder or --bridge socket.");
        }

        Option? stray = All.Skip(2).FirstOrDefault(option => parsed.GetResult(option) is { Implicit: false });
        if (kind == BridgeName.Direct && stray is not null)
        {
            throw new UsageException($"{stray.Name} needs --bridge folder or --bridge socket.");
        }

        string? folder =
            parsed.GetValue(Folder)?.FullName ?? (outFolder is null ? null : Path.Combine(outFolder, BridgeFolder.DefaultName));
        if (kind == BridgeName.Folder && folder is null)
        {
            throw new UsageException("--bridge folder needs --folder.");
        }

        if (kind == BridgeName.Folder && role != DriveRole.Client)
        {
            BridgeFolder.Check(folder!);
        }

        return new BridgePlan(
            kind,
            role,
            folder ?? "",
            parsed.GetValue(At) is { } at ? ParsePlace(at) : null,
            parsed.GetValue(Token),
            TimeSpan.FromSeconds(parsed.GetValue(Patience))
        );
    }

    private static IPEndPoint ParsePlace(string text) =>
        IPEndPoint.TryParse(text, out IPEndPoint? place) && place.Port > 0
            ? place
            : throw new UsageException($"--at takes an IP address with a port, e.g. 127.0.0.1:4567, not '{text}'.");

    private static Option<double> Patient()
    {
        Option<double> patience = ValueParsers.Number(
            "--patience",
            "S",
            "Time to wait for the other side, seconds of real time",
            value => value is > 0 and <= 86_400,
            "a number greater than 0 and at most 86400"
        );
        patience.DefaultValueFactory = _ => 60;
        return patience;
    }

    private static Option<string> Word(string name, string form, string description, string value) =>
        new(name)
        {
            Description = description,
            HelpName = form,
            DefaultValueFactory = _ => value,
        };
}
