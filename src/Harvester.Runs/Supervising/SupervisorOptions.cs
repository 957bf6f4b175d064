namespace Harvester.Runs.Supervising;

/// <summary>What is supervised, and how patiently.</summary>
public sealed record SupervisorOptions
{
    /// <summary>Longest wait between two restarts.</summary>
    public static TimeSpan MaxDelay { get; } = TimeSpan.FromMinutes(5);

    /// <summary>The program.</summary>
    public required string Program { get; init; }

    /// <summary>Its arguments.</summary>
    public required IReadOnlyList<string> Arguments { get; init; }

    /// <summary>Argument that is added when the program is started again; null for none.</summary>
    public string? RestartArgument { get; init; } = "--resume";

    /// <summary>The heartbeat file.</summary>
    public required string HeartbeatPath { get; init; }

    /// <summary>Time without a new heartbeat after which the program hangs; also the time it has to end after its last word.</summary>
    public TimeSpan Timeout { get; init; } = TimeSpan.FromSeconds(60);

    /// <summary>Time from the start until the program must be running.</summary>
    public TimeSpan StartTimeout { get; init; } = TimeSpan.FromSeconds(600);

    /// <summary>Time that heartbeats may go on without a new frame or trial while the program is running.</summary>
    public TimeSpan Stall { get; init; } = TimeSpan.FromSeconds(300);

    /// <summary>Wait before the first restart; it doubles with every restart without progress.</summary>
    public TimeSpan Delay { get; init; } = TimeSpan.FromSeconds(5);

    /// <summary>Restarts in a row without progress before the supervisor gives up.</summary>
    public int MaxRestarts { get; init; } = 5;

    /// <summary>Whether the process of a heartbeat is not checked, because it is counted by another system.</summary>
    public bool AllowsAnyProcess { get; init; }

    /// <summary>Whether the command only starts the program, and may end before its first heartbeat.</summary>
    public bool IsLauncher { get; init; }

    /// <summary>How often the heartbeat is read.</summary>
    public TimeSpan Poll => TimeSpan.FromMilliseconds(Math.Clamp(Timeout.TotalMilliseconds / 20, 10, 1000));

    /// <summary>The wait before a restart.</summary>
    /// <param name="restart">Its number among those without progress, from 1.</param>
    public TimeSpan DelayOf(int restart) =>
        TimeSpan.FromSeconds(Math.Min(Delay.TotalSeconds * Math.Pow(2, restart - 1), MaxDelay.TotalSeconds));
}
