using System.CommandLine;
using Harvester.Datasets.Files;

namespace Harvester.Cli.Arguments;

/// <summary>--images: whether files are linked or copied. Several commands share it.</summary>
internal static class TransferOption
{
    /// <summary>Creates the option.</summary>
    /// <param name="files">What is linked or copied, such as "images".</param>
    public static Option<ImageTransfer> Create(string files) =>
        ValueParsers.Choice<ImageTransfer>("--images", $"Link {files} (hard links, where possible) or copy them [default: link]");
}
