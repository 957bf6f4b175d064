using System.CommandLine;
using Harvester.Runs.Faults;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;

namespace Harvester.Cli.Arguments;

/// <summary>The noise of the inertial unit.</summary>
internal sealed class ImuOptions
{
    private Option<string?> Noise { get; } =
        new("--imu-noise")
        {
            Description = $"Noise of the inertial unit: {ImuNoise.Form} in SI units per √Hz, or {ImuNoise.Adis16448} [default: none]",
            HelpName = "A=N,B=N",
        };

    public void AddTo(Command command) => command.Options.Add(Noise);

    /// <summary>The noise; null for an ideal unit.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="isOn">Whether the harvest has an inertial unit.</param>
    /// <param name="seed">The seed of the harvest.</param>
    /// <exception cref="UsageException">The text is not a noise specification, or there is no inertial unit.</exception>
    public ImuNoise? Parse(ParseResult parsed, bool isOn, int seed) =>
        parsed.GetValue(Noise) is not { } text ? null
        : !isOn ? throw new UsageException($"--imu-noise needs {FrameChannels.Imu.Switch.Option}.")
        : ImuNoise.Parse(text) is not { } noise
            ? throw new UsageException(
                $"--imu-noise takes a comma-separated list of {ImuNoise.Form}, {ImuNoise.Limits}, or {ImuNoise.Adis16448}, not '{text}'."
            )
        : noise with { Seed = seed };
}
