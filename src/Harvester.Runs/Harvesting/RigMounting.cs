using Harvester.Geometry;
using Harvester.Runs.Faults;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Harvesting;

/// <summary>Plans a harvest with a rig, and mounts the rig on the car of a simulated game.</summary>
public static class RigMounting
{
    /// <summary>Checks that no sensor is inside the car, and gives the camera the place of the rig's first one.</summary>
    /// <exception cref="UsageException">A sensor is inside the car.</exception>
    public static void Mount(Rig rig, SimulatedGame game)
    {
        foreach (
            (string name, Pose mount) in rig
                .Cameras.Select(camera => (camera.Name, camera.Mount))
                .Concat(rig.Lidars.Select(lidar => (lidar.Name, lidar.Mount)))
                .Concat(rig.Radars.Select(radar => (radar.Name, radar.Mount)))
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

    /// <summary>The plan with a rig: each moment then has a frame for each camera.</summary>
    public static HarvestPlan Planned(HarvestPlan plan, Rig rig)
    {
        int views = rig.Cameras.Count;
        int frames = checked(plan.Frames * views);
        return plan with
        {
            Frames = frames,
            FovDegrees = rig.Cameras[0].VerticalFovDegrees,
            Options = plan.Options with
            {
                Rig = rig,
                Image = rig.Cameras[0].Image,
                Lens = rig.Cameras[0].Lens,
                MaxFrames = frames,
                Places = plan.Options.Places! with { ViewsPerMoment = views },
                QueueCapacity = Math.Max(plan.Options.QueueCapacity, 2 * views),
            },
        };
    }
}
