using Harvester.Capture.Harvesting;
using Harvester.Capture.Storage;
using ToyGame;

if (args is not [string folder])
{
    Console.Error.WriteLine("Usage: ToyGame FOLDER");
    return 2;
}

var town = new Town();
var options = new HarvestOptions
{
    Image = Town.Image,
    MaxFrames = 1,
    Masks = true,
};
using var writer = new SessionWriter(folder, new SessionOrigin { Game = "toy", Tool = "ToyGame" });
using var harvest = new HarvestSession(options, town.Ports, writer);
while (!harvest.Step().IsOver)
{
    // A game draws and moves here. The harvest asks it to stand still for each frame.
    writer.WaitForRoom();
    town.Tick();
}

Console.WriteLine(harvest.Fault ?? $"{harvest.Counters.Captured} frame written to {folder}");
return harvest.Fault is null ? 0 : 1;
