using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Game;

namespace Harvester.Cli.Harvesting;

/// <summary>Mounts a rig on the car of a simulated game.</summary>
internal static class RigMounting
{
    /// <summary>Checks that no sensor is inside the car, and gives the camera the place of the rig's first one.</summary>
    /// <exception cref="UsageException">A sensor is inside the car.</exception>
    public static void Mount(Rig rig, SimulatedGame game)
    {
        foreach (
            (string name, Pose mount) in rig
                .Cameras.Select(camera => (camera.Name, camera.Mount))
                .Concat(rig.Lidars.Select(lidar => (lidar.Name, lidar.Mount)))
        )
        {
            if (game.IsInsideCar(rig.OnVehicle(mount).Position))
            {
                throw new UsageException(
                    $"'{name}' of the rig '{rig.Name}' is inside the body of the car, which would hide everything. Move it outside."
                );
            }
        }

        game.Ports.RigCamera!.Show(rig.Cameras[0], rig.OnVehicle(rig.Cameras[0].Mount));
    }
}
