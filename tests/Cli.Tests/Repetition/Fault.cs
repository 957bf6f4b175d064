namespace Harvester.Cli.Tests.Repetition;

/// <summary>What happens to one operation.</summary>
/// <param name="Operation">Which one.</param>
/// <param name="Error">The code that it fails with, of Linux.</param>
/// <param name="Kills">Whether nothing is written or deleted from then on, as after SIGKILL.</param>
/// <param name="Vanishes">Whether every operation fails from then on, as when the drive is gone.</param>
/// <param name="CanExchange">Whether the file system can exchange two folders.</param>
internal sealed record Fault(FileOperation Operation, int Error, bool Kills = false, bool Vanishes = false, bool CanExchange = true)
{
    public const int InputOutput = 5;
    public const int PermissionDenied = 13;
    public const int DiskFull = 28;

    public static Fault None { get; } = new(FileOperation.None, 0);

    private string Kind =>
        Kills ? "kill"
        : Vanishes ? "no drive"
        : $"error {Error}";

    public override string ToString() => $"{Kind} at {Operation}{(CanExchange ? "" : " without exchange")}";
}
